#include "session/membrane/HangMembrane.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "core/Error.h"
#include "core/Text.h"
#include "scene/Scene.h"
#include "session/TypedPlace.h"
#include "session/cut/CutEdit.h"
#include "session/membrane/DefaultField.h"
#include "session/membrane/FirstPlace.h"
#include "session/membrane/MembraneEdit.h"
#include "session/membrane/Sketch.h"
#include "session/membrane/StrokeSamples.h"
#include "session/model/TypesAt.h"

namespace velum::session {

namespace {

void expectCount(const std::vector<double>& numbers, std::size_t count, const char* field, const char* form) {
  if (!numbers.empty() && numbers.size() != count)
    throw ArgumentError(fmt::format("{}: give {}, not {} numbers", field, form, numbers.size()));
}

glm::dvec3 vectorOf(const std::vector<double>& v) { return {v[0], v[1], v[2]}; }

/// The frame as the window would hang it, but with the axis and the place that are asked for.
scene::Cut frameOf(const scene::Scene& scene, const HangMembrane& asked) {
  scene::Scene seen = scene;
  if (!asked.axis.empty()) {
    // The frame hangs across the direction in which one looks.
    seen.camera = scene::frameCamera(scene, scene::StandardView::Anterior, 1.0);
    seen.camera.eye = seen.camera.target + vectorOf(asked.axis) * 1000.0;
  }
  scene::Cut cut = makeCut(seen, scene::CutShape::Membrane);
  cut.name = "Membrane";
  // Made along the data's nearest axis, as one that is put in by hand.
  if (!asked.axis.empty()) cut.axis = glm::normalize(vectorOf(asked.axis));
  scene::Bounds bounds = scene::computeBounds(scene);
  glm::dvec3 middle = (bounds.min + bounds.max) * 0.5, z(scene::worldFromCut(cut)[2]);
  double deep = glm::dot(glm::abs(z), bounds.max - bounds.min);
  double position = asked.position < 0.0 ? 0.5 : asked.position;
  cut.centre = middle + z * (deep * (position - 0.5));
  if (asked.reach > 0.0) cut.size.z = asked.reach;
  return cut;
}

/// "x,y,z:x,y,z@radius": the points of a path.
scene::Stroke strokeOf(const std::string& text, const char* field) {
  auto refuse = [&](const char* why) {
    throw ArgumentError(fmt::format("{} {}: {}; expected points and a radius, x,y,z:x,y,z@radius", field, text, why));
  };
  scene::Stroke stroke;
  std::string_view rest = text;
  auto take = [&](char mark) {
    bool isNext = rest.starts_with(mark);
    if (isNext) rest.remove_prefix(1);
    return isNext;
  };
  do {
    auto point = takePlace(rest);
    if (!point) refuse("a point has three numbers");
    stroke.path.push_back(*point);
  } while (take(':'));
  if (take('@')) {
    stroke.radius = takeNumber(rest).value_or(0.0);
    if (!(stroke.radius > 0) || !std::isfinite(stroke.radius)) refuse("the radius must be more than 0");
  }
  if (!rest.empty()) refuse("it goes on after its end");
  return stroke;
}

/// Fits the curve to the strokes, as the window does.
void sketch(const scene::VolumeLayer& layer, scene::ForceField& field, const HangMembrane& asked) {
  std::vector<scene::Stroke> strokes;
  for (const auto& text : asked.sketch) strokes.push_back(strokeOf(text, "sketch"));
  for (const auto& text : asked.avoid) {
    strokes.push_back(strokeOf(text, "avoid"));
    strokes.back().avoid = true;
  }
  if (strokes.empty()) return;
  if (!layer.data) throw ArgumentError("sketch: there is no volume under the strokes");
  setStrokes(field, strokes, layer, wholeHistogram(layer));
  if (field.byValue.empty() && !asked.sketch.empty())
    throw ArgumentError(
        "sketch: the strokes lie outside the volume, or nothing under them differs from the rest by its values");
}

void protectTypes(const scene::Scene& scene, scene::Membrane& membrane, const std::vector<std::string>& types) {
  if (!types.empty()) expectModelInReach(scene);
  for (const auto& path : types) {
    std::vector<std::string> found = protectableTypes(*scene.model.data, path);
    if (found.empty()) {
      std::string meant = nearestPath(*scene.model.data, path);
      throw ArgumentError(fmt::format("types {}: no type or compartment of the model is called so{}", path,
                                      meant.empty() ? "" : fmt::format(" (is {} meant?)", meant)));
    }
    for (const auto& type : found) protectType(membrane, type);
  }
}

bool saysWhatToProtect(const HangMembrane& asked) {
  return !asked.values.empty() || !asked.place.empty() || !asked.structures.empty() || !asked.types.empty() ||
         !asked.sketch.empty();
}

void protect(const scene::Scene& scene, scene::Membrane& membrane, const HangMembrane& asked) {
  if (!saysWhatToProtect(asked)) membrane.field = defaultField(scene);
  if (!asked.values.empty()) {
    if (!(asked.values[0] < asked.values[1])) throw ArgumentError("values A,B: A must be less than B");
    protectValues(membrane, asked.values[0], asked.values[1]);
  }
  for (int id : asked.structures) protectStructure(membrane, id);
  protectTypes(scene, membrane, asked.types);
  if (!asked.place.empty() && !protectTissue(membrane, scene.volume, vectorOf(asked.place)))
    throw ArgumentError(
        fmt::format("place {},{},{}: that is outside the volume", asked.place[0], asked.place[1], asked.place[2]));
  sketch(scene.volume, membrane.field, asked);
}

}  // namespace

int leastPieceOf(const std::string& text) {
  if (text == "auto") return -1;
  auto voxels = numberIn(text);
  if (voxels && *voxels >= 1 && *voxels <= 1e9 && *voxels == int(*voxels)) return int(*voxels);
  throw ArgumentError(fmt::format("leastPiece {}: give a number of voxels, 1 or more, or auto", text));
}

scene::Cut hungMembrane(const scene::Scene& scene, const HangMembrane& asked, Progress& progress) {
  expectCount(asked.values, 2, "values", "A,B");
  expectCount(asked.place, 3, "place", "x,y,z");
  expectCount(asked.axis, 3, "axis", "x,y,z");
  if (!asked.axis.empty() && vectorOf(asked.axis) == glm::dvec3(0.0))
    throw ArgumentError("axis 0,0,0: it has no direction");
  if ((!asked.values.empty() || !asked.place.empty()) && !asked.sketch.empty())
    throw ArgumentError("sketch: it fits the curve to its strokes: leave values and place out");
  scene::Cut cut = frameOf(scene, asked);
  protect(scene, *cut.membrane, asked);
  if (!asked.leastPiece.empty()) cut.membrane->field.leastPiece = leastPieceOf(asked.leastPiece);
  if (asked.denoise) cut.membrane->field.denoise = true;
  if (asked.position < 0.0) cut = placedToKeep(scene, cut, progress, !(asked.reach > 0.0)).value_or(cut);
  return cut;
}

}  // namespace velum::session
