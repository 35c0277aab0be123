#include "session/extrusion/Pull.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/FinestVoxels.h"
#include "scene/SectionPlane.h"
#include "scene/Shown.h"
#include "scene/StructureAt.h"
#include "session/cut/CutEdit.h"
#include "session/growth/Growths.h"
#include "session/structure/StructureEdit.h"

namespace velum::session {

namespace {

/// Out of which plane the steps of a structure grow that is pulled out of a cut. Around closed shapes it grows in all
/// directions, from a membrane's sheet from the farthest that it can lie.
void setPlane(scene::Growth& growth, const scene::Cut& cut, double distance) {
  growth.axis = isFlat(cut) ? pullDirection(cut, cut.centre) : glm::dvec3(0.0);
  growth.centre = isFlat(cut) ? cut.centre : glm::dvec3(0.0);
  growth.distance = isFlat(cut) ? distance : scene::Growth::kEndless;
  if (!scene::isMembrane(cut)) return;
  growth.centre -= 0.5 * cut.size.z * growth.axis;
  growth.distance += cut.size.z;
}

glm::vec3 colorAt(const scene::TransferFunction& transfer, double value) {
  const auto& colors = transfer.colors;
  if (colors.empty()) return glm::vec3(0.85f, 0.8f, 0.7f);
  auto after = std::find_if(colors.begin(), colors.end(), [&](const auto& p) { return p.value >= value; });
  if (after == colors.end()) return colors.back().color;
  if (after == colors.begin()) return after->color;
  const auto& before = *(after - 1);
  return glm::mix(before.color, after->color, float((value - before.value) / (after->value - before.value)));
}

double valueNear(const scene::VolumeLayer& layer, glm::dvec3 world) {
  FinestVoxels voxels(*layer.data);
  const Volume& grid = voxels.grid();
  glm::ivec3 voxel(glm::round(glm::dvec3(glm::inverse(grid.worldFromVoxel) * glm::dvec4(world, 1.0))));
  voxel = glm::clamp(voxel, glm::ivec3(0), grid.dims - 1);
  return voxels.valueOrNan(voxel, scene::shownChannel(layer), scene::shownTimeStep(layer));
}

/// The voxel of a range nearest to a place on the face, of those that lie before it: that of the place itself may lie
/// behind, or be one that noise has put out of the range. One with such a neighbour, or nothing would grow from it.
/// @param within  label that it has; 0: any
std::optional<glm::dvec3> seedBefore(const scene::Scene& scene, const scene::Cut& cut, glm::dvec3 world,
                                     const MaterialRange& range, int within) {
  constexpr int kFurthest = 2;  // voxels
  FinestVoxels voxels(*scene.volume.data);
  const Volume& grid = voxels.grid();
  auto field = within != 0 ? scene::structureFieldOf(scene) : nullptr;  // held while it is asked
  auto isWanted = [&](glm::ivec3 voxel) {
    if (glm::any(glm::lessThan(voxel, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(voxel, grid.dims)))
      return false;
    double value = voxels.valueOrNan(voxel, scene.volume.channel, scene.volume.timeStep);
    glm::dvec3 middle(grid.worldFromVoxel * glm::dvec4(voxel, 1.0));
    return value >= range.low && value <= range.high && depthInCut(cut, middle) > 0.0 &&
           (within == 0 || int(scene::structureAt(scene, middle).id) == within);
  };
  auto hasNeighbour = [&](glm::ivec3 voxel) {
    for (int axis = 0; axis < 3; ++axis)
      for (int step : {-1, 1}) {
        glm::ivec3 neighbour = voxel;
        neighbour[axis] += step;
        if (isWanted(neighbour)) return true;
      }
    return false;
  };
  glm::ivec3 here(glm::round(glm::dvec3(glm::inverse(grid.worldFromVoxel) * glm::dvec4(world, 1.0))));
  std::optional<glm::dvec3> best;
  std::pair<bool, double> least(true, scene::Growth::kEndless);  // alone, how far off
  for (glm::ivec3 off(-kFurthest); off.z <= kFurthest; ++off.z)
    for (off.y = -kFurthest; off.y <= kFurthest; ++off.y)
      for (off.x = -kFurthest; off.x <= kFurthest; ++off.x) {
        glm::ivec3 voxel = here + off;
        if (!isWanted(voxel)) continue;
        glm::dvec3 middle(grid.worldFromVoxel * glm::dvec4(voxel, 1.0));
        std::pair<bool, double> now(!hasNeighbour(voxel), glm::distance(middle, world));
        if (now < least) least = now, best = middle;
      }
  return best;
}

/// @param within  label of which a part is taken; 0: what has none
std::optional<Pull> newPull(const scene::Scene& scene, const scene::Cut& cut, glm::dvec3 world,
                            const std::optional<MaterialRange>& range, int within) {
  auto id = freeStructureId(scene);
  if (!range || !id || scene.labels.growths.size() >= scene::kMostGrowths) return std::nullopt;
  auto seed = seedBefore(scene, cut, world, *range, within);
  if (!seed && within != 0) return std::nullopt;
  scene::Growth growth;
  growth.structure = *id;
  growth.seeds = {seed.value_or(world)};
  growth.low = range->low;
  growth.high = range->high;
  growth.within = within;
  growth.channel = scene::shownChannel(scene.volume);
  growth.timeStep = scene::shownTimeStep(scene.volume);
  setPlane(growth, cut, 0.0);
  return Pull{cut.id, *id, newStructure(scene, *id, valueNear(scene.volume, growth.seeds[0])), growth};
}

/// True when a step begins where another ended.
bool goesOn(const scene::Growth& step, scene::Growth wanted) {
  wanted.distance = step.distance;
  wanted.seeds = step.seeds;
  return step == wanted;
}

/// How far a plane lies before that of a step, along the step's axis.
double depthOf(const scene::Growth& plane, const scene::Growth& step) {
  return glm::dot(plane.centre - step.centre, step.axis);
}

/// Takes in what another step with the same axis reaches, and what lies between the two: so what grows from it has a
/// way.
void takeIn(scene::Growth& step, const scene::Growth& other) {
  double first = depthOf(other, step);
  double end = std::max(step.distance, first + other.distance);
  first = std::min(first, 0.0);
  step.centre += first * step.axis;
  step.distance = end - first;
}

/// The steps that grow a structure out of a cut that has moved: those with seeds, and one that brings what they have
/// found to where the cut is now. What was held, where it would have flowed into another, ends where it was held.
void carry(std::vector<scene::Growth>& steps, const Extrusion& extrusion, const scene::Cut& before,
           const scene::Cut& now) {
  auto isMeant = [&](const scene::Growth& step) {
    return step.structure == extrusion.structure && step.axis != glm::dvec3(0.0) && growsOutOf(step, before);
  };
  auto last = std::find_if(steps.rbegin(), steps.rend(), isMeant);
  if (last == steps.rend()) return;
  scene::Growth full = *last, step = *last;
  setPlane(full, before, extrusion.distance);
  setPlane(step, now, extrusion.distance);
  step.seeds.clear();
  double end = last->distance + depthOf(*last, step);
  if (depthOf(*last, full) + last->distance < full.distance) step.distance = std::clamp(end, 0.0, step.distance);
  std::erase_if(steps, [&](const auto& other) { return other.seeds.empty() && isMeant(other); });
  auto base = std::find_if(steps.rbegin(), steps.rend(), [&](const scene::Growth& other) {
    return other.structure == step.structure && other.axis == step.axis && !other.seeds.empty();
  });
  if (base != steps.rend()) {
    bool isFound = depthOf(step, *base) >= 0.0 && depthOf(step, *base) + step.distance <= base->distance;
    if (isFound) return;
    takeIn(step, *base);
  }
  if (steps.size() < scene::kMostGrowths) steps.push_back(step);
}

}  // namespace

bool growsOutOf(const scene::Growth& growth, const scene::Cut& cut) {
  scene::Growth plane = growth;
  setPlane(plane, cut, 0.0);
  double slack = 1e-9 * (glm::length(plane.centre) + glm::length(growth.centre));
  double depth = depthOf(plane, growth);
  return plane.axis == growth.axis && depth >= -slack && depth <= growth.distance + slack;
}

Pull pullAgain(const scene::Scene& scene, const Extrusion& extrusion) {
  Pull pull{extrusion.cut, extrusion.structure, {}, {}};
  const scene::Cut* cut = scene::findCut(scene, extrusion.cut);
  const scene::Growth* last = lastGrowth(scene, extrusion.structure);
  if (!cut || !last) return pull;
  pull.growth = *last;
  pull.growth->seeds.clear();
  setPlane(*pull.growth, *cut, 0.0);
  return pull;
}

scene::Structure newStructure(const scene::Scene& scene, int id, double value) {
  std::size_t count = 1;
  for (const auto& structure : scene.labels.structures) count += structure.name.starts_with("Region ");
  scene::Structure structure;
  structure.id = id;
  structure.name = fmt::format("Region {}", count);
  structure.color = colorAt(scene::currentTransfer(scene.volume), value);
  structure.tint = 0.0;
  return structure;
}

void addStructure(scene::LabelLayer& labels, const scene::Structure& row) {
  auto after =
      std::find_if(labels.structures.begin(), labels.structures.end(), [&](const auto& s) { return s.id >= row.id; });
  if (after == labels.structures.end() || after->id != row.id) labels.structures.insert(after, row);
}

std::optional<Pull> beginPull(const scene::Scene& scene, int cutId, glm::dvec3 world, int structure) {
  HistogramMemo histograms;
  return beginPull(scene, cutId, world, structure, histograms);
}

std::optional<Pull> beginPull(const scene::Scene& scene, int cutId, glm::dvec3 world, int structure,
                              HistogramMemo& histograms) {
  const scene::Cut* cut = scene::findCut(scene, cutId);
  if (!cut) return std::nullopt;
  if (structure != 0) return pullAgain(scene, {cutId, structure, 0.0});
  if (!scene.volume.data) return std::nullopt;
  return newPull(scene, *cut, world, materialRangeAt(scene.volume, world, histograms), 0);
}

std::optional<Pull> beginPartPull(const scene::Scene& scene, int cutId, glm::dvec3 world, int structure) {
  const scene::Cut* cut = scene::findCut(scene, cutId);
  const scene::Structure* whole = findStructure(scene, structure);
  if (!cut || !whole || !scene.volume.data) return std::nullopt;
  MaterialRange all{scene.volume.data->range.x, scene.volume.data->range.y};
  auto pull = newPull(scene, *cut, world, all, structure);
  if (!pull || !pull->added) return std::nullopt;
  scene::Structure part = *whole;
  part.id = pull->added->id;
  part.name = fmt::format("{}, a part", structureName(scene, structure));
  pull->added = part;
  return pull;
}

void pullTo(scene::Scene& scene, const Pull& pull, double distance) {
  scene::Cut* cut = scene::findCut(scene, pull.cut);
  if (!cut) return;
  setExtrusion(*cut, pull.structure, distance);
  if (pull.added && distance > 0.0) addStructure(scene.labels, *pull.added);
  if (!pull.growth || !(distance > 0.0)) return;
  markGiven(scene.labels);
  scene.labels.visible = true;
  scene::Growth step = *pull.growth;
  setPlane(step, *cut, distance);
  auto& steps = scene.labels.growths;
  if (!steps.empty() && steps.back().structure == step.structure && goesOn(steps.back(), step))
    steps.back().distance = std::max(steps.back().distance, step.distance);
  else if (steps.size() < scene::kMostGrowths)
    steps.push_back(step);
}

void carryPulled(scene::Scene& scene, const scene::Cut& before) {
  const scene::Cut* now = scene::findCut(scene, before.id);
  if (!now || (cutFrame(*now) == cutFrame(before) && now->centre == before.centre && now->size == before.size &&
               now->invert == before.invert && now->shape == before.shape))
    return;
  for (const auto& extrusion : extrusionsOf(scene))
    if (extrusion.cut == before.id) carry(scene.labels.growths, extrusion, before, *now);
}

void moveCut(scene::Scene& scene, scene::Cut moved) {
  const scene::Cut* cut = scene::findCut(scene, moved.id);
  if (!cut) return;
  scene::Cut before = *cut;
  replaceCut(scene, std::move(moved));
  carryPulled(scene, before);
}

}  // namespace velum::session
