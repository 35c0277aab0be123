#include "session/membrane/SheetMotion.h"

#include "core/Clock.h"
#include "gpu/Allocation.h"
#include "gpu/Program.h"
#include "membrane/sheet/SheetIndex.h"

namespace velum::session {

namespace {

/// A sheet that starts unseen is shown from this step on: until then it lies nearly flat, and a drag would flicker.
constexpr int kWarmSteps = 40;
/// Most steps at a time: without asking the GPU nobody knows how long they take.
constexpr int kMostSteps = 20;

/// A membrane in the frame for which forces were made.
scene::Cut frameOf(const scene::Cut& cut, const MadeForces& made) {
  scene::Cut moving = cut;
  moving.centre = made.cut.centre;
  moving.axis = made.cut.axis;
  moving.spinDeg = made.cut.spinDeg;
  moving.size = made.cut.size;
  moving.membrane->field.rule = made.cut.membrane->field.rule;
  return moving;
}

}  // namespace

void SheetMotion::begin(const scene::Cut& cut, const MadeForces& made, const SheetPlace& start, State as) {
  mCut = frameOf(cut, made);
  mTimeStep = made.timeStep;
  mSimulation->begin(mCut, made.forces, start.in(mCut));
  mState = as;
  mMs = 0.0;
}

void SheetMotion::advance(double budgetMs) {
  auto start = Clock::now();
  int steps = 0;
  do mSimulation->advance(1);
  while (++steps < kMostSteps && !mSimulation->isAtRest() && msSince(start) < budgetMs);
  gpu::finish();
  gpu::throwIfExhausted();
  double ms = msSince(start), stepMs = ms / steps;
  mMs += ms;
  mStepMs = mStepMs > 0 ? 0.8 * mStepMs + 0.2 * stepMs : stepMs;
  if (mState == State::Unseen && (mSimulation->steps() >= kWarmSteps || mSimulation->isAtRest())) mState = State::Shown;
}

SheetPlace SheetMotion::fittedPlace(bool isAnchored) const {
  SheetPlace at = place();
  at.shape = membrane::fitShape(at.shape, mCut.membrane->cloth.particles, mCut.size);
  if (isAnchored) membrane::anchor(at.shape, mCut, mTimeStep);
  return at;
}

void SheetMotion::releaseGpu() {
  mSimulation.emplace();
  mState = State::None;
}

}  // namespace velum::session
