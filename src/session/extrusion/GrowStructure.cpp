#include "session/extrusion/GrowStructure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/Error.h"
#include "core/FinestVoxels.h"
#include "growth/GrowRule.h"
#include "growth/LabelsFor.h"
#include "scene/Scene.h"
#include "scene/Shown.h"
#include "session/TypedPlace.h"
#include "session/extrusion/MaterialRange.h"
#include "session/extrusion/Pull.h"
#include "session/growth/Growths.h"
#include "session/structure/StructureEdit.h"

namespace velum::session {

namespace {

std::string textOf(glm::dvec3 v) { return fmt::format("{},{},{}", v.x, v.y, v.z); }

void expectInside(const Volume& volume, const char* field, glm::dvec3 place, const std::string& text) {
  if (!growth::isInside(volume, growth::voxelAt(volume, place)))
    throw ArgumentError(fmt::format("{} {}: that is outside the volume", field, text));
}

/// "x,y,z;x,y,z;..." in the volume.
std::vector<glm::dvec3> pathOf(const Volume& volume, const char* field, const std::string& text) {
  std::vector<glm::dvec3> path;
  std::istringstream points(text);
  for (std::string point; std::getline(points, point, ';');) {
    std::string_view rest = point;
    auto place = takePlace(rest);
    if (!place || !rest.empty()) throw ArgumentError(fmt::format("{} {}: give x,y,z", field, point));
    expectInside(volume, field, *place, point);
    path.push_back(*place);
  }
  return path;
}

double valueThere(const scene::Growth& step, const FinestVoxels& voxels, glm::dvec3 place) {
  return voxels.value(growth::voxelAt(voxels.grid(), place), step.channel, step.timeStep);
}

bool hasValueOf(const scene::Growth& step, const FinestVoxels& voxels, glm::dvec3 place) {
  double value = valueThere(step, voxels, place);
  return value >= step.low && value <= step.high;
}

/// The voxels along strokes that have values of a step's range.
void addStrokes(const std::vector<std::string>& strokes, const char* field, const scene::Growth& step,
                const FinestVoxels& voxels, std::vector<glm::dvec3>& places) {
  for (const std::string& text : strokes) {
    std::size_t before = places.size();
    for (glm::dvec3 place : placesAlong(voxels.grid(), pathOf(voxels.grid(), field, text)))
      if (hasValueOf(step, voxels, place)) places.push_back(place);
    if (places.size() == before)
      throw ArgumentError(
          fmt::format("{} {}: no value along it is from {:.6g} to {:.6g}; draw it elsewhere, or give the range", field,
                      text, step.low, step.high));
  }
}

/// Places that are not of it. One that has no value of it would say nothing.
void addOtherPlaces(scene::Growth& step, const GrowStructure& asked, const FinestVoxels& voxels) {
  for (glm::dvec3 place : asked.others) {
    expectInside(voxels.grid(), "others", place, textOf(place));
    if (!hasValueOf(step, voxels, place))
      throw ArgumentError(
          fmt::format("others {}: the value there is not from {:.6g} to {:.6g}, so it does not grow there; choose a "
                      "place that it takes",
                      textOf(place), step.low, step.high));
    step.others.push_back(place);
  }
  addStrokes(asked.otherStrokes, "otherStrokes", step, voxels, step.others);
  if (asked.guard && !step.others.empty())
    throw ArgumentError("guard and others: what is told where it leaks is not guarded; leave one of them out");
}

void setRange(scene::Growth& step, const GrowStructure& asked, const scene::VolumeLayer& layer,
              const FinestVoxels& voxels) {
  if (!asked.range.empty() && asked.range.size() != 2) throw ArgumentError("range: give A,B");
  if (asked.range.empty()) {
    glm::dvec3 first =
        step.seeds.empty() ? pathOf(voxels.grid(), "strokes", asked.strokes.front()).at(0) : step.seeds.front();
    auto material = materialRangeAt(layer, first);
    if (!material)
      throw ArgumentError(fmt::format("seed {}: nothing is known of the values there; give the range", textOf(first)));
    step.low = material->low, step.high = material->high;
  } else {
    if (asked.range[0] > asked.range[1]) throw ArgumentError("range A,B: A must not be more than B");
    step.low = asked.range[0], step.high = asked.range[1];
  }
  for (const auto& seed : step.seeds)
    if (!hasValueOf(step, voxels, seed))
      throw ArgumentError(
          fmt::format("seed {}: the value there is {:.6g}, not from {:.6g} to {:.6g}; choose another place, or the "
                      "range",
                      textOf(seed), valueThere(step, voxels, seed), step.low, step.high));
}

void setPlane(scene::Growth& step, const GrowStructure& asked) {
  if (asked.plane.empty()) {
    if (std::isfinite(asked.distance))
      throw ArgumentError("distance needs plane: it is from the plane that it is measured");
    if (asked.guard) throw ArgumentError("guard needs plane: it watches how wide the structure is away from the plane");
    return;
  }
  if (asked.plane.size() != 4) throw ArgumentError("plane: give nx,ny,nz,d");
  glm::dvec3 normal(asked.plane[0], asked.plane[1], asked.plane[2]);
  double squared = glm::dot(normal, normal);
  if (!(squared > 0.0)) throw ArgumentError("plane: the normal must not be 0,0,0");
  step.axis = normal;
  step.centre = normal * (asked.plane[3] / squared);
  step.distance = asked.distance;
}

void setWithin(scene::Growth& step, const GrowStructure& asked, const scene::Scene& scene) {
  step.within = asked.within;
  if (step.within == 0) return;
  auto ids = scene.labels.data ? scene.labels.data->idsInUse() : std::vector<std::uint16_t>();
  if (std::find(ids.begin(), ids.end(), step.within) == ids.end())
    throw ArgumentError(fmt::format("within {}: no voxel has that label", step.within));
}

}  // namespace

scene::Growth stepOf(const scene::Scene& scene, const GrowStructure& asked) {
  if (!scene.volume.data) throw InputError("there is no volume to grow in: name a file that has one");
  if (asked.seeds.empty() && asked.strokes.empty())
    throw ArgumentError("seed or strokes are needed: a place on the structure");
  FinestVoxels voxels(*scene.volume.data);
  scene::Growth step;
  auto id = freeStructureId(scene);
  if (!id || scene.labels.growths.size() >= scene::kMostGrowths)
    throw InputError("the labels have no number left for another structure");
  step.structure = *id;
  for (glm::dvec3 seed : asked.seeds) expectInside(voxels.grid(), "seed", seed, textOf(seed));
  step.seeds = asked.seeds;
  step.channel = scene::shownChannel(scene.volume);
  step.timeStep = scene::shownTimeStep(scene.volume);
  step.steepest = asked.steepest;
  step.closing = asked.closing;
  step.fillHoles = asked.fillHoles;
  setRange(step, asked, scene.volume, voxels);
  addStrokes(asked.strokes, "strokes", step, voxels, step.seeds);
  addOtherPlaces(step, asked, voxels);
  setPlane(step, asked);
  setWithin(step, asked, scene);
  return step;
}

void addGrowth(scene::Scene& scene, const scene::Growth& step, const std::string& name) {
  scene::Structure row = newStructure(scene, step.structure, 0.5 * (step.low + step.high));
  if (!name.empty()) row.name = name;
  markGiven(scene.labels);
  addStructure(scene.labels, row);
  scene.labels.growths.push_back(step);
}

}  // namespace velum::session
