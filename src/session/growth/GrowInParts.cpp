#include "session/growth/GrowInParts.h"

#include <algorithm>
#include <cmath>

#include "core/Clock.h"
#include "core/FinestVoxels.h"
#include "growth/FirstDoubt.h"
#include "growth/GrowDomain.h"

namespace velum::session {

namespace {

/// A piece of work: the front is shown as often, and Esc is heard.
constexpr double kWorkMs = 40.0;
/// Slabs that are grown at once at first; more where they are done sooner than this.
constexpr double kFirstSlabs = 2.0, kQuickMs = 8.0;

/// True when `wanted` is the same step as the grown one, and goes as far or farther.
bool isContinued(const scene::Growth& grown, scene::Growth wanted) {
  if (!(grown.distance <= wanted.distance)) return false;
  wanted.distance = grown.distance;
  return grown == wanted;
}

/// Beyond this depth nothing of the volume lies; 0 where a step has no plane, and grows at once.
double deepest(const Volume& volume, const scene::Growth& step) {
  FinestVoxels voxels(volume);
  growth::GrowDomain domain(voxels.grid(), step.centre, step.axis, step.distance);
  return domain.isEverywhere() ? 0.0 : domain.depthRange({0, 0, 0}, voxels.grid().dims - 1).y;
}

}  // namespace

bool isOnTheWay(const Steps& grown, const Steps& wanted) {
  if (grown.size() > wanted.size()) return false;
  if (grown.empty()) return true;
  return std::equal(grown.begin(), grown.end() - 1, wanted.begin()) &&
         (grown.back() == wanted[grown.size() - 1] || isContinued(grown.back(), wanted[grown.size() - 1]));
}

bool isOnTheWay(const Progressed& now, const Steps& wanted) {
  if (!isOnTheWay(now.steps, wanted)) return false;
  // One with others begins anew from what was there before it.
  bool isAnew = !now.steps.empty() && !now.steps.back().others.empty();
  if (isAnew && !now.before && now.steps.back() != wanted[now.steps.size() - 1]) return false;
  return now.steps.empty() || isAnew || bool(now.rough) || now.steps.back() == wanted[now.steps.size() - 1];
}

Progressed GrowInParts::growSome(const Shared<Volume>& of, const Shared<LabelVolume>& ground, Progressed to,
                                 const Goal& all, const std::function<Watch(int)>& watch, Progress& progress) {
  auto start = Clock::now();
  double slabs = kFirstSlabs;
  while (to.steps != all.steps && slabs > 0.0 && msSince(start) < kWorkMs) {
    bool isNew = to.steps.empty() || to.steps.back() == all.steps[to.steps.size() - 1];
    std::size_t place = to.steps.size() - (isNew ? 0 : 1);
    const scene::Growth& step = all.steps[place];
    double reached = isNew ? 0.0 : to.steps.back().distance;
    if (isNew) {
      to.steps.push_back(step);
      to.rough = to.before = to.labels;
      to.voxels = 0;
      to.figures = {};
    }
    if (all.isCarried(place)) {
      to.steps.back() = step;
      to.take(mOverTime.labelsAt(step.timeStep, place + 1, of, ground, all.made, progress));
    } else if (!step.others.empty()) {
      growWhole(of, to, step, progress);
    } else {
      slabs = growPart(of, to, step, reached, slabs, watch(step.structure), progress);
    }
  }
  return to;
}

/// So many slabs more of the last step. @return how many may be next; 0: none, it leaks
double GrowInParts::growPart(const Shared<Volume>& of, Progressed& to, const scene::Growth& step, double reached,
                             double slabs, Watch watch, Progress& progress) {
  scene::Growth part = step;
  // Who gives a structure more seeds has seen what it is.
  auto isOfIt = [&](const scene::Growth& other) { return other.structure == step.structure; };
  bool isAlone = std::count_if(to.steps.begin(), to.steps.end(), isOfIt) <= 1;
  bool isFirst = isAlone && watch == Watch::All && step.distance > 0.0 && reached < growth::firstSlabEnd(*of, step);
  auto hold = [&] {
    part.distance = reached;
    to.rough = mGrower.grow(of, to.rough, part, {.guard = false, .begun = {}}, progress).labels;
    to.labels = growth::smoothRegion(of, to.rough, part, progress).labels;
    to.steps.back() = part;
    to.leak = Leak{step.structure, reached, 0.0};
    return 0.0;
  };
  if (isFirst && reached == 0.0 && growth::reachesTheDarkest(*of, step)) return hold();
  double next = reached + slabs * growth::slabThickness(FinestVoxels(*of).grid());
  if (next < std::min(step.distance, deepest(*of, step))) part.distance = next;
  auto start = Clock::now();
  growth::Grown grown = mGrower.grow(of, to.rough, part, {.guard = watch != Watch::Not, .begun = {}}, progress);
  if (isFirst && growth::isMostOfItsPlane(*of, *grown.labels, part)) return hold();
  if (msSince(start) < kQuickMs) slabs *= 2.0;
  to.figures.slabs += grown.slabs;
  to.figures.ms += grown.ms;
  if (grown.leak) {
    to.figures.leakDepth = grown.leak->depth;
    to.figures.leakArea = grown.leak->area;
    to.figures.widestBefore = grown.leak->widestBefore;
    part.distance = std::max(reached, grown.distance);
    to.leak = Leak{step.structure, part.distance, grown.leak->area / std::max(grown.leak->widestBefore, 1e-12)};
  }
  to.labels = to.rough = grown.labels;
  to.voxels += std::int64_t(grown.voxels);
  to.steps.back() = part;
  if (grown.leak || part == step) {
    growth::Smoothed smoothed = growth::smoothRegion(of, to.rough, part, progress);
    to.labels = smoothed.labels;
    to.figures.smoothed = smoothed.voxels;
  }
  return grown.leak ? 0.0 : slabs;
}

/// Grows a step that has others (scene::Growth::others) as far as it goes: where its border to the others lies depends
/// on all of it.
void GrowInParts::growWhole(const Shared<Volume>& of, Progressed& to, const scene::Growth& step, Progress& progress) {
  growth::Grown grown = mGrower.grow(of, to.before, step, {}, progress);
  growth::Smoothed smoothed = growth::smoothRegion(of, grown.labels, step, progress, grown.others);
  to.labels = smoothed.labels;
  to.figures = {.slabs = grown.slabs, .ms = grown.ms, .smoothed = smoothed.voxels};
  to.rough = grown.labels;
  to.voxels = std::int64_t(grown.voxels);
  to.steps.back() = step;
}

}  // namespace velum::session
