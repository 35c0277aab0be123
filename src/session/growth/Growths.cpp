#include "session/growth/Growths.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <ranges>
#include <set>
#include <tuple>

#include "core/FinestVoxels.h"
#include "growth/GrowRule.h"
#include "scene/Scene.h"
#include "scene/Shown.h"

namespace velum::session {

namespace {

/// The most places along one piece of a stroke.
constexpr double kMostAlong = 1e5;
/// How many voxels beside a place the voxel that was meant may lie.
constexpr int kBeside = 2;

/// The voxel nearest to `here` whose value is in the range of a step.
std::optional<glm::ivec3> voxelNear(const FinestVoxels& voxels, const scene::Growth& step, int timeStep,
                                    glm::ivec3 here) {
  const Volume& grid = voxels.grid();
  std::optional<glm::ivec3> best;
  double least = scene::Growth::kEndless;
  for (glm::ivec3 off(-kBeside); off.z <= kBeside; ++off.z)
    for (off.y = -kBeside; off.y <= kBeside; ++off.y)
      for (off.x = -kBeside; off.x <= kBeside; ++off.x) {
        double away = glm::length(glm::dmat3(grid.worldFromVoxel) * glm::dvec3(off));
        if (away >= least || !growth::isInside(grid, here + off)) continue;
        double value = voxels.valueOrNan(here + off, step.channel, timeStep);
        if (value >= step.low && value <= step.high) least = away, best = here + off;
      }
  return best;
}

/// @param grid  of the volume's finest level
bool isSeed(const scene::Scene& scene, const Volume& grid, int structure, glm::ivec3 voxel) {
  return std::any_of(scene.labels.growths.begin(), scene.labels.growths.end(), [&](const scene::Growth& step) {
    return step.structure == structure && std::any_of(step.seeds.begin(), step.seeds.end(), [&](glm::dvec3 seed) {
             return growth::voxelAt(grid, seed) == voxel;
           });
  });
}

}  // namespace

std::vector<scene::Growth> growthsNow(const scene::Scene& scene) {
  std::vector<scene::Growth> steps = scene.labels.growths;
  if (scene.volume.data)
    for (auto& step : steps) step.timeStep = scene::shownTimeStep(scene.volume);
  return steps;
}

bool isGrown(const scene::Scene& scene) { return scene.labels.grown == growthsNow(scene); }

void markGiven(scene::LabelLayer& labels) {
  if (labels.growths.empty() && labels.grown.empty()) labels.given = labels.data;
}

std::vector<std::string> settleGrowths(scene::Scene& scene, Progress& progress) {
  growth::GrowOverTime known;
  return settleGrowths(scene, known, progress);
}

std::vector<std::string> settleGrowths(scene::Scene& scene, growth::GrowOverTime& known, Progress& progress) {
  auto& labels = scene.labels;
  if (isGrown(scene) || !scene.volume.data) return {};
  if (labels.grown.empty() && !labels.given) labels.given = labels.data;
  std::vector<scene::Growth> steps = growthsNow(scene);
  if (steps.empty()) {
    labels.data = labels.given;
  } else {
    labels.data =
        known.labelsAt(steps.front().timeStep, steps.size(), scene.volume.data, labels.given, labels.growths, progress);
  }
  labels.grown = std::move(steps);
  scene::completeStructures(labels);
  return labels.growths.empty() ? std::vector<std::string>() : labels.data->warnings;
}

const scene::Growth* lastGrowth(const scene::Scene& scene, int structure) {
  for (const auto& step : std::views::reverse(scene.labels.growths))
    if (step.structure == structure) return &step;
  return nullptr;
}

void changeGrowth(scene::Scene& scene, int structure, const std::function<void(scene::Growth&)>& change) {
  for (auto& step : scene.labels.growths)
    if (step.structure == structure) change(step);
  growOn(scene, structure);
}

std::vector<glm::dvec3> placesAlong(const Volume& volume, std::span<const glm::dvec3> path) {
  constexpr double kStep = 0.25;  // voxels
  FinestVoxels voxels(volume);
  const Volume& grid = voxels.grid();
  glm::dmat4 voxelFromWorld = glm::inverse(grid.worldFromVoxel);
  std::set<std::tuple<int, int, int>> seen;
  std::vector<glm::dvec3> places;
  auto add = [&](glm::dvec3 place) {
    glm::ivec3 voxel = growth::voxelAt(grid, place);
    if (growth::isInside(grid, voxel) && seen.insert({voxel.x, voxel.y, voxel.z}).second)
      places.push_back(glm::dvec3(grid.worldFromVoxel * glm::dvec4(voxel, 1.0)));
  };
  for (std::size_t i = 0; i < path.size(); ++i) {
    glm::dvec3 from = path[i], to = path[std::min(i + 1, path.size() - 1)];
    double length = glm::length(glm::dmat3(voxelFromWorld) * (to - from));
    int count = int(std::ceil(std::min(length / kStep, kMostAlong)));
    for (int k = 0; k <= count; ++k) add(glm::mix(from, to, count > 0 ? double(k) / count : 0.0));
  }
  return places;
}

std::size_t addSeeds(scene::Scene& scene, int structure, std::span<const glm::dvec3> places) {
  const scene::Growth* last = lastGrowth(scene, structure);
  auto& steps = scene.labels.growths;
  if (!last || !scene.volume.data || steps.size() >= scene::kMostGrowths) return 0;
  FinestVoxels voxels(*scene.volume.data);
  scene::Growth step = *last;
  step.timeStep = scene::shownTimeStep(scene.volume);
  step.seeds.clear();
  for (glm::dvec3 place : places) {
    glm::ivec3 voxel = growth::voxelAt(voxels.grid(), place);
    if (!growth::isInside(voxels.grid(), voxel)) continue;
    double value = voxels.valueOrNan(voxel, step.channel, step.timeStep);
    if (value >= step.low && value <= step.high) step.seeds.push_back(place);
  }
  if (step.seeds.empty()) return 0;
  steps.push_back(step);
  return steps.back().seeds.size();
}

std::size_t addOthers(scene::Scene& scene, int structure, std::span<const glm::dvec3> places) {
  const scene::Growth* last = lastGrowth(scene, structure);
  if (!last || !scene.volume.data) return 0;
  FinestVoxels voxels(*scene.volume.data);
  int timeStep = scene::shownTimeStep(scene.volume);
  std::vector<glm::dvec3> others;
  for (glm::dvec3 place : places) {
    auto voxel = voxelNear(voxels, *last, timeStep, growth::voxelAt(voxels.grid(), place));
    if (!voxel || isSeed(scene, voxels.grid(), structure, *voxel)) continue;
    glm::dvec3 middle(voxels.grid().worldFromVoxel * glm::dvec4(*voxel, 1.0));
    bool isKnown = std::find(last->others.begin(), last->others.end(), middle) != last->others.end();
    if (!isKnown && std::find(others.begin(), others.end(), middle) == others.end()) others.push_back(middle);
  }
  if (others.empty()) return 0;
  changeGrowth(scene, structure,
               [&](scene::Growth& step) { step.others.insert(step.others.end(), others.begin(), others.end()); });
  return others.size();
}

void removeGrown(scene::Scene& scene, int structure) {
  if (!lastGrowth(scene, structure)) return;
  std::erase_if(scene.labels.growths, [&](const auto& step) { return step.structure == structure; });
  std::erase_if(scene.labels.structures, [&](const auto& row) { return row.id == structure; });
  for (auto& cut : scene.cuts)
    std::erase_if(cut.spares, [&](const auto& spare) { return spare.structure == structure; });
}

void holdGrowth(scene::Scene& scene, const Leak& held) {
  for (auto& step : std::views::reverse(scene.labels.growths))
    if (step.structure == held.structure) {
      step.distance = std::min(step.distance, held.distance);
      return;
    }
}

void growOn(scene::Scene& scene, int structure) {
  auto& steps = scene.labels.growths;
  auto last = std::find_if(steps.rbegin(), steps.rend(), [&](const auto& step) { return step.structure == structure; });
  if (last == steps.rend()) return;
  // The step's plane may lie behind that of its cut: where the cut was, or as deep as a membrane's sheet can lie.
  for (const auto& cut : scene.cuts)
    for (const auto& spare : cut.spares) {
      if (spare.structure != structure) continue;
      double sheet = scene::isMembrane(cut) ? 0.5 * cut.size.z : 0.0;
      bool isAlong = std::abs(glm::dot(glm::normalize(cut.axis), last->axis)) > 1.0 - 1e-9;
      double behind = isAlong ? glm::dot(cut.centre - last->centre, last->axis) : 0.0;
      last->distance = std::max(last->distance, behind + sheet + spare.distance);
    }
}

}  // namespace velum::session
