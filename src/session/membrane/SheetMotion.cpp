#include "session/membrane/SheetMotion.h"

#include <utility>

#include "core/Clock.h"
#include "gpu/Allocation.h"
#include "gpu/Loss.h"
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
  mStart = start.in(mCut);
  end();  // until it has begun, which fails where the context is lost
  mIsKept = false;
  mSimulation->begin(mCut, made.forces, mStart);
  mState = as;
  mMs = 0.0;
}

void SheetMotion::advance(double budgetMs) {
  mIsKept = false;
  auto start = Clock::now();
  int steps = 0;
  do mSimulation->advance(1);
  while (++steps < kMostSteps && !mSimulation->isAtRest() && msSince(start) < budgetMs);
  gpu::finish();
  gpu::throwIfLost();
  gpu::throwIfExhausted();
  double ms = msSince(start), stepMs = ms / steps;
  mMs += ms;
  mStepMs = mStepMs > 0 ? 0.8 * mStepMs + 0.2 * stepMs : stepMs;
  see();
}

void SheetMotion::see() {
  if (mState == State::Unseen && (mSimulation->steps() >= kWarmSteps || mSimulation->isAtRest())) mState = State::Shown;
}

SheetPlace SheetMotion::fittedPlace(bool isAnchored) const {
  SheetPlace at = place();
  at.shape = membrane::fitShape(at.shape, mCut.membrane->cloth.particles, mCut.size);
  if (isAnchored) membrane::anchor(at.shape, mCut, mTimeStep);
  return at;
}

SheetPlace SheetMotion::place() const {
  SheetPlace place{mSimulation->shape(), mCut, mTimeStep};
  gpu::throwIfLost();
  return place;
}

void SheetMotion::releaseGpu() {
  if (isInterrupted()) return void(mSimulation.emplace());
  bool isOver = mState == State::None || (mIsKept && mSimulation->isAtRest());
  if (isOver)
    mState = State::None;
  else
    mInterrupted = Interrupted{mSimulation->forces(), mSimulation->steps()};
  mSimulation.emplace();
}

void SheetMotion::resume() {
  if (!isInterrupted()) return;
  mSimulation.emplace();
  mSimulation->begin(mCut, mInterrupted->forces, mStart);
  mSimulation->advance(mInterrupted->steps);
  gpu::throwIfLost();
  gpu::throwIfExhausted();
  mInterrupted.reset();
  see();
}

}  // namespace velum::session
