#include "growth/GrowOverTime.h"

#include <algorithm>

#include "core/FinestVoxels.h"
#include "growth/GrowRule.h"
#include "growth/LabelsFor.h"
#include "growth/SmoothRegion.h"

namespace velum::growth {

namespace {

/// Labels that are kept: of some structures at all time steps.
constexpr std::size_t kMostKnown = 512;

/// True when a seed has no value of the range at a time step.
bool isLost(const FinestVoxels& voxels, const scene::Growth& step, glm::dvec3 seed, int timeStep) {
  glm::ivec3 voxel = voxelAt(voxels.grid(), seed);
  if (!isInside(voxels.grid(), voxel)) return false;
  double value = voxels.value(voxel, step.channel, timeStep);
  return !(value >= step.low && value <= step.high);
}

bool losesSeeds(const FinestVoxels& voxels, const scene::Growth& step, int timeStep) {
  auto isAnyLost = [&](const std::vector<glm::dvec3>& places) {
    return std::any_of(places.begin(), places.end(),
                       [&](glm::dvec3 place) { return isLost(voxels, step, place, timeStep); });
  };
  return isAnyLost(step.seeds) || isAnyLost(step.others);
}

}  // namespace

Shared<LabelVolume> GrowOverTime::labelsAt(int timeStep, std::size_t count, const Shared<Volume>& volume,
                                           const Shared<LabelVolume>& given, std::span<const scene::Growth> steps,
                                           Progress& progress) {
  follow(volume, given, steps);
  return labelsAt(timeStep, count, progress);
}

/// Forgets what does not lead to these steps.
void GrowOverTime::follow(const Shared<Volume>& volume, const Shared<LabelVolume>& given,
                          std::span<const scene::Growth> steps) {
  if (mVolume != volume || mGiven != given || !mGround) {
    mVolume = volume;
    mGiven = given;
    mGround = labelsFor(*volume, given);
    mKnown.clear();
  }
  auto same =
      std::size_t(std::mismatch(mSteps.begin(), mSteps.end(), steps.begin(), steps.end()).first - mSteps.begin());
  std::erase_if(mKnown, [&](const Known& known) { return known.count > same; });
  mSteps.assign(steps.begin(), steps.end());
}

const GrowOverTime::Known* GrowOverTime::find(int timeStep, std::size_t count) const {
  auto known = std::find_if(mKnown.begin(), mKnown.end(),
                            [&](const Known& k) { return k.timeStep == timeStep && k.count == count; });
  return known == mKnown.end() ? nullptr : &*known;
}

Shared<LabelVolume> GrowOverTime::labelsAt(int timeStep, std::size_t count, Progress& progress) {
  if (count == 0) return mGround;
  if (const Known* known = find(timeStep, count)) return known->labels;
  Shared<LabelVolume> before = labelsAt(timeStep, count - 1, progress);
  scene::Growth step = mSteps[count - 1];
  checkRule(ruleOf(step), *mVolume);
  Known begun = begunAt(timeStep, count, progress);
  FinestVoxels voxels(*mVolume);
  if (begun.labels)
    for (auto* places : {&step.seeds, &step.others})
      std::erase_if(*places, [&](glm::dvec3 place) { return isLost(voxels, step, place, timeStep); });
  step.timeStep = timeStep;
  Grown grown = mGrower.grow(mVolume, before, step, {.begun = begun.labels, .othersBegun = begun.others}, progress);
  Shared<LabelVolume> labels = smoothRegion(mVolume, grown.labels, step, progress, grown.others).labels;
  mKnown.push_back({timeStep, count, labels, grown.others});
  if (mKnown.size() > kMostKnown) mKnown.pop_front();
  return labels;
}

/// What a carried step that loses seeds begins at; nothing where it needs none.
GrowOverTime::Known GrowOverTime::begunAt(int timeStep, std::size_t count, Progress& progress) {
  const scene::Growth& step = mSteps[count - 1];
  if (timeStep == step.timeStep) return {};
  FinestVoxels voxels(*mVolume);
  if (!losesSeeds(voxels, step, timeStep)) return {};
  // Back to where it needs nothing, then from there on, so that nothing waits for more than what is beside it.
  int towards = step.timeStep > timeStep ? 1 : -1, from = timeStep + towards;
  while (from != step.timeStep && !find(from, count) && losesSeeds(voxels, step, from)) from += towards;
  for (; from != timeStep + towards; from -= towards) labelsAt(from, count, progress);
  Shared<LabelVolume> labels = labelsAt(from, count, progress);
  return {from, count, labels, find(from, count)->others};
}

Shared<LabelVolume> growLabels(const Shared<Volume>& volume, const Shared<LabelVolume>& given,
                               std::span<const scene::Growth> steps, int timeStep, Progress& progress) {
  return GrowOverTime().labelsAt(timeStep, steps.size(), volume, given, steps, progress);
}

}  // namespace velum::growth
