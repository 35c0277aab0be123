#include "session/film/ReadyFilms.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/Error.h"
#include "core/Task.h"
#include "scene/Scene.h"
#include "scene/Shown.h"
#include "session/extrusion/Extrusion.h"
#include "session/extrusion/PulledEnd.h"
#include "session/film/FilmKeys.h"
#include "session/structure/StructureSizes.h"

namespace velum::session {

namespace {

using scene::Cut;
using scene::Ease;
using scene::Scene;

std::string number(double value) { return std::isfinite(value) ? fmt::format("{:.17g}", value) : "null"; }

std::string pathOf(const Cut& cut, std::string_view field) { return fmt::format("cuts[#{}].{}", cut.id, field); }

void expect(const Scene& scene, ReadyFilm film) {
  if (std::string why = whyNoFilm(scene, film); !why.empty())
    throw ArgumentError(fmt::format("no film '{}': {}", enumName(film), why));
}

int timeStepsOf(const Scene& scene) { return scene.volume.data ? scene.volume.data->timeSteps : 1; }

bool hasInstances(const Scene& scene) { return scene.model.data && !scene.model.data->compartments.empty(); }

bool hasCutOn(const Scene& scene, bool isMembrane) {
  return std::ranges::any_of(scene::enabledOf(scene.cuts),
                             [&](const Cut& cut) { return !isMembrane || scene::isMembrane(cut); });
}

/// How far a flat cut has to go back for all of the data to lie on the side that it leaves.
double wayOut(const Cut& cut, const scene::Bounds& bounds, glm::dvec3 out) {
  double farthest = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    glm::dvec3 share(corner & 1, corner >> 1 & 1, corner >> 2);
    farthest = std::max(farthest, glm::dot(glm::mix(bounds.min, bounds.max, share) - cut.centre, out));
  }
  return farthest + (scene::isMembrane(cut) ? 0.5 * cut.size.z : 0.0);
}

/// A scene with a cut where it takes nothing, and the field in which that differs.
std::string takenOut(Scene& scene, Cut& cut) {
  scene::Bounds bounds = scene::computeBounds(scene);
  if (isFlat(cut)) {
    glm::dvec3 out = pullDirection(cut, cut.centre);
    cut.centre += wayOut(cut, bounds, out) * out;
    return pathOf(cut, "centre");
  }
  if (cut.invert)
    cut.size +=
        4.0 * (glm::length(bounds.max - bounds.min) + glm::distance(cut.centre, 0.5 * (bounds.min + bounds.max)));
  else
    cut.size = glm::dvec3(0.0);
  return pathOf(cut, "size");
}

/// Lets cuts come in between two times. @param back  0: they stay; else the time at which they are out again
void comeIn(Scene& scene, FilmKeys& keys, int id, bool onlyMembranes, double from, double to, double back) {
  bool isAny = false;
  for (const Cut& cut : std::vector<Cut>(scene.cuts)) {
    bool isMeant = id > 0 ? cut.id == id : cut.enabled;
    if (!isMeant || cut.shape == scene::CutShape::Everywhere || (onlyMembranes && !scene::isMembrane(cut))) continue;
    Scene out = scene;
    std::string path = takenOut(out, *scene::findCut(out, cut.id));
    keys.clear(path);
    // Fast where there is still air, slowly where it cuts.
    keys.setAsIn(out, path, from, Ease::Out);
    keys.setAsIn(scene, path, to, Ease::In);
    if (back > to) keys.setAsIn(out, path, back, Ease::Both);
    isAny = true;
  }
  if (!isAny) throw ArgumentError("there is no such cut that could come in");
}

/// The row of the root, which holds for all types that have none of their own.
scene::TypeSpare rowForAll(const Model& model, double share, double viewShare) {
  scene::TypeSpare row;
  row.type = model.compartments.front().name;
  row.share = share;
  row.viewShare = viewShare;
  return row;
}

/// A cut's rows with one for all types, so that they are the same rows throughout the film.
std::vector<scene::TypeSpare> allRows(const Cut& cut, const Model& model) {
  std::vector<scene::TypeSpare> rows = cut.model.spares;
  scene::TypeSpare rest = rowForAll(model, 0.0, 0.0);
  if (std::ranges::find(rows, rest.type, &scene::TypeSpare::type) == rows.end()) rows.push_back(rest);
  return rows;
}

/// The rows where a cut takes nothing, and where it takes all that it reaches. A cut everywhere reaches all instances,
/// and would remove all: at first it clears the view alone.
void fillRows(Cut& cut, const Model& model, double share) {
  bool isEverywhere = cut.shape == scene::CutShape::Everywhere;
  for (scene::TypeSpare& row : cut.model.spares = allRows(cut, model)) {
    row.share = isEverywhere ? 1.0 : share;
    row.viewShare = share;
    row.amount = 0.0;
    row.aperture = 1.0;
    row.distance = scene::Spare::kEndless;
  }
  cut.model.leastMass = cut.model.leastCopies = 0.0;
  cut.model.mostMass = cut.model.mostCopies = scene::Spare::kEndless;
}

}  // namespace

ReadyFilm usualFilm(const Scene& scene) { return timeStepsOf(scene) > 1 ? ReadyFilm::Time : ReadyFilm::Turn; }

std::string whyNoFilm(const Scene& scene, ReadyFilm film) {
  switch (film) {
    case ReadyFilm::Turn:
    case ReadyFilm::Title:
      return {};
    case ReadyFilm::Time:
      return timeStepsOf(scene) > 1 ? "" : "the volume has no time steps";
    case ReadyFilm::Pull:
      return extrusionsOf(scene).empty() ? "no structure is pulled out of a cut" : "";
    case ReadyFilm::Membrane:
      return hasCutOn(scene, true) ? "" : "no membrane is on";
    case ReadyFilm::Fly:
      return scene.labels.data && !scene.labels.structures.empty() ? "" : "there are no structures";
    case ReadyFilm::Equalize:
      if (!hasInstances(scene)) return "there is no model of molecules";
      [[fallthrough]];
    default:
      return hasCutOn(scene, false) ? "" : "no cut is on";
  }
}

Scene withReadyFilm(Scene scene, ReadyFilm film, int frames) {
  scene.timeline.tracks.clear();
  scene.timeline.rangeStart = scene.timeline.rangeEnd = 0.0;
  addReadyFilm(scene, film, {0.0, frames / scene.timeline.framesPerSecond});
  return scene;
}

void addReadyFilm(Scene& scene, ReadyFilm film, FilmSpan span) {
  expect(scene, film);
  switch (film) {
    case ReadyFilm::Turn:
      return addTurn(scene, span, 1.0, false);
    case ReadyFilm::Cut:
      return addCutting(scene, span, 0, false);
    case ReadyFilm::Membrane:
      return addSinking(scene, span, 0, false);
    case ReadyFilm::Pull:
      return addPulling(scene, span, 0.0, 0.0);
    case ReadyFilm::Equalize:
      return addEqualizing(scene, span, 0.0);
    case ReadyFilm::Fly:
      return addFlight(scene, span, scene.labels.structures.front().id, 0.9);
    case ReadyFilm::Time:
      return addTimeSteps(scene, span, 1.0);
    case ReadyFilm::Compare:
      return addComparison(scene, span, 0.35);
    case ReadyFilm::Title:
      return addTitle(scene, span, "Title", 0.5, scene::CaptionPlace::Bottom);
  }
}

void addTurn(Scene& scene, FilmSpan span, double turns, bool gently) {
  FilmKeys keys(scene, span);
  std::string path(scene::kOrbitPath);
  Ease ease = gently ? Ease::Both : Ease::Linear;
  keys.clear(path);
  keys.set(path, keys.timeAt(0.0), "0", ease);
  keys.set(path, keys.timeAt(1.0), number(360.0 * turns), ease);
}

void addCutting(Scene& scene, FilmSpan span, int cut, bool back) {
  expect(scene, ReadyFilm::Cut);
  FilmKeys keys(scene, span);
  comeIn(scene, keys, cut, false, keys.pictureAt(0.0), keys.pictureAt(back ? 0.5 : 1.0), keys.timeAt(back ? 1.0 : 0.0));
}

void addSinking(Scene& scene, FilmSpan span, int cut, bool back) {
  expect(scene, ReadyFilm::Membrane);
  FilmKeys keys(scene, span);
  comeIn(scene, keys, cut, true, keys.pictureAt(0.0), keys.pictureAt(back ? 0.5 : 1.0), keys.timeAt(back ? 1.0 : 0.0));
}

void addPulling(Scene& scene, FilmSpan span, double overlap, double hold) {
  expect(scene, ReadyFilm::Pull);
  FilmKeys keys(scene, span);
  std::vector<Extrusion> all = extrusionsOf(scene);
  double count = double(all.size());
  double length = (1.0 - hold) / (1.0 + (count - 1.0) * (1.0 - overlap));  // of one, as a share of the film
  double begin = 0.0;
  for (const Extrusion& one : all) {
    const Cut& cut = *scene::findCut(scene, one.cut);
    // What lies beyond the structure's end would be a time in which nothing moves.
    double end = std::min(one.distance, pulledEnd(scene, cut, one.structure));
    std::string path = pathOf(cut, fmt::format("spares[{}].distance", one.structure));
    keys.clear(path);
    keys.set(path, keys.pictureAt(begin), "0", Ease::Both);
    keys.set(path, keys.pictureAt(std::min(begin + length, 1.0)), number(end), Ease::Both);
    begin += length * (1.0 - overlap);
  }
}

void addEqualizing(Scene& scene, FilmSpan span, double hold) {
  expect(scene, ReadyFilm::Equalize);
  FilmKeys keys(scene, span);
  double still = hold / 3.0, move = (1.0 - hold) / 2.0;
  Scene whole = scene, taken = scene;
  for (std::size_t i = 0; i < scene.cuts.size(); ++i) {
    const Cut cut = scene.cuts[i];
    if (!cut.enabled) continue;
    fillRows(whole.cuts[i], *scene.model.data, 1.0);
    fillRows(taken.cuts[i], *scene.model.data, 0.0);
    // What is to come back has the reach that it will have, and nothing of it is there yet.
    Scene back = taken, end = scene;
    end.cuts[i].model.spares = allRows(cut, *scene.model.data);
    for (std::size_t k = 0; k < end.cuts[i].model.spares.size(); ++k)
      back.cuts[i].model.spares[k].distance = end.cuts[i].model.spares[k].distance;
    std::string rows = pathOf(cut, "model.spares");
    keys.clear(rows);
    keys.setAsIn(whole, rows, keys.pictureAt(0.0), Ease::Linear);
    if (still > 0.0) keys.setAsIn(whole, rows, keys.pictureAt(still), Ease::Linear);
    if (still > 0.0) keys.setAsIn(taken, rows, keys.pictureAt(still + move), Ease::Hold);
    keys.setAsIn(back, rows, keys.pictureAt(2.0 * still + move), Ease::Linear);
    keys.setAsIn(end, rows, keys.pictureAt(2.0 * (still + move)), Ease::Linear);
    for (const char* filter : {"model.leastMass", "model.mostMass", "model.leastCopies", "model.mostCopies"}) {
      std::string path = pathOf(cut, filter);
      keys.clear(path);
      if (scene::valueAt(whole, path) == scene::valueAt(scene, path)) continue;
      keys.setAsIn(whole, path, keys.pictureAt(0.0), Ease::Hold);
      keys.setAsIn(scene, path, keys.pictureAt(2.0 * still + move), Ease::Hold);
    }
  }
}

void addFlight(Scene& scene, FilmSpan span, int structure, double fill) {
  expect(scene, ReadyFilm::Fly);
  Progress quiet;
  auto sizes = countStructures(*scene.labels.data, quiet);
  StructureSize size = sizes[structure];
  if (size.voxels == 0) throw ArgumentError("the structure is empty: there is nothing to fly to");
  FilmKeys keys(scene, span);
  Scene there = scene;
  glm::dvec3 middle = middleOfStructure(*scene.labels.data, structure, size);
  double radius = radiusOfStructure(*scene.labels.data, size);
  there.camera = closeUp(scene.camera, middle, radius, 1.0, fill);
  keys.clear("camera");
  keys.setAsIn(scene, "camera", keys.pictureAt(0.0), Ease::Smooth);
  keys.setAsIn(there, "camera", keys.pictureAt(0.85), Ease::Smooth);
}

void addTimeSteps(Scene& scene, FilmSpan span, double rounds) {
  expect(scene, ReadyFilm::Time);
  FilmKeys keys(scene, span);
  const std::string path = "volume.timeStep";
  keys.clear(path);
  // Each step is seen for as long: the number that is rounded to it goes from half below it to half above it.
  int steps = timeStepsOf(scene), last = steps - 1;
  constexpr double kLittle = 1e-6;  // seconds: a time at which two steps meet is the later one's
  double step = span.seconds / (rounds * steps);
  for (int round = 0; round < int(std::ceil(rounds - 1e-9)); ++round) {
    double begin = span.start + round * steps * step - kLittle;
    keys.set(path, std::max(begin + 0.5 * step, 0.0), "0", Ease::Linear);
    double end = begin + (steps - 0.5) * step;
    keys.set(path, end, std::to_string(last), Ease::Hold);
    if (round + 1 < rounds) keys.set(path, end + 0.5 * step, "0", Ease::Hold);
  }
}

void addComparison(Scene& scene, FilmSpan span, double hold) {
  expect(scene, ReadyFilm::Compare);
  FilmKeys keys(scene, span);
  double move = 0.5 * (1.0 - 2.0 * std::min(hold, 0.49));
  comeIn(scene, keys, 0, false, keys.pictureAt(0.5 - move), keys.pictureAt(0.5 + move), 0.0);
}

}  // namespace velum::session
