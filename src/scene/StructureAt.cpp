#include "scene/StructureAt.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <optional>

#include "core/FinestVoxels.h"
#include "scene/Scene.h"
#include "scene/Shown.h"

namespace velum::scene {

namespace {

constexpr double kMostSamples = 65536;

/// Where all but the last hundredth of a channel's values lie, of a sample of them.
glm::dvec2 usualValues(const Volume& volume, int channel, int timeStep) {
  int every = std::max(1, int(std::ceil(std::cbrt(double(voxelCount(volume)) / kMostSamples))));
  std::vector<double> values;
  glm::ivec3 at;
  for (at.z = every / 2; at.z < volume.dims.z; at.z += every)
    for (at.y = every / 2; at.y < volume.dims.y; at.y += every)
      for (at.x = every / 2; at.x < volume.dims.x; at.x += every)
        if (double value = valueAt(volume, at, channel, timeStep); std::isfinite(value)) values.push_back(value);
  if (values.empty()) return volume.range;
  auto nth = [&](double share) {
    auto place = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return *place;
  };
  double low = nth(0.01);
  return {low, nth(0.99)};
}

/// How far values go from the ends of a range, to either side; not much farther than the range is wide.
double scaleOf(const Growth& step, glm::dvec2 usual) {
  double inside = std::min(step.high, usual.y) - std::max(step.low, usual.x);
  double scale = std::max({step.low - usual.x, usual.y - step.high, inside});
  if (inside > 0.0) scale = std::min(scale, 4.0 * inside);
  return std::isfinite(scale) && scale > 0.0 ? scale : 1.0;
}

bool hasSameBorder(const Growth& a, const Growth& b) {
  return a.low == b.low && a.high == b.high && a.channel == b.channel && a.within == b.within &&
         a.steepest == b.steepest;
}

bool isByValues(const Growth& step, const Volume& volume) {
  bool isRange = std::isfinite(step.low) || std::isfinite(step.high);
  return isRange && step.low <= step.high && !std::isfinite(step.steepest) && step.channel >= 0 &&
         step.channel < volume.channels;
}

}  // namespace

std::vector<ValueBorder> valueBordersOf(const Scene& scene) {
  std::vector<ValueBorder> borders;
  const LabelLayer& labels = scene.labels;
  const Shared<Volume>& volume = scene.volume.data;
  if (!volume || !labels.data || labels.data->dims() != FinestVoxels(*volume).grid().dims) return borders;
  std::map<int, const Growth*> steps;  // by structure; nothing where they differ
  for (const Growth& step : labels.grown) {
    auto [known, isNew] = steps.emplace(step.structure, &step);
    if (!isNew && known->second && !hasSameBorder(*known->second, step)) known->second = nullptr;
  }
  std::map<int, glm::dvec2> usual;  // by channel
  int timeStep = shownTimeStep(scene.volume);
  for (auto [structure, step] : steps) {
    if (!step || !isByValues(*step, *volume)) continue;
    auto known = usual.find(step->channel);
    if (known == usual.end()) known = usual.emplace(step->channel, usualValues(*volume, step->channel, timeStep)).first;
    borders.push_back({std::uint16_t(structure), std::uint16_t(step->within), volume, step->channel, timeStep,
                       step->low, step->high, scaleOf(*step, known->second)});
  }
  return borders;
}

namespace {

/// The field that was asked for last, and what it is a function of. Nobody's data lives longer for it.
struct Known {
  std::uint64_t labels = 0, volume = 0;  ///< ids
  std::vector<Growth> grown;
  int timeStep = 0;
  std::weak_ptr<const StructureField> field;
};

}  // namespace

std::shared_ptr<const StructureField> structureFieldOf(const Scene& scene) {
  static std::mutex mutex;
  static Known known;
  std::lock_guard lock(mutex);
  std::shared_ptr<const StructureField> before = known.field.lock();
  bool hasSameBorders = before && known.volume == scene.volume.data.id() && known.timeStep == scene.volume.timeStep &&
                        known.grown == scene.labels.grown;
  if (hasSameBorders && known.labels == scene.labels.data.id()) return before;
  std::vector<ValueBorder> borders = hasSameBorders ? before->cover().borders() : valueBordersOf(scene);
  auto field = std::make_shared<const StructureField>(LabelCover(scene.labels.data, std::move(borders)), before.get());
  known = {scene.labels.data.id(), scene.volume.data.id(), scene.labels.grown, scene.volume.timeStep, field};
  return field;
}

StructurePlace structureAt(const Scene& scene, glm::dvec3 world) {
  if (!scene.labels.data || !scene.labels.visible) return {};
  glm::dmat4 voxelFromWorld = glm::inverse(scene.labels.data->worldFromVoxel());
  return structureFieldOf(scene)->at(glm::dvec3(voxelFromWorld * glm::dvec4(world, 1.0)));
}

}  // namespace velum::scene
