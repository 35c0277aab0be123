#include "render/WorkQueue.h"

#include <algorithm>

#include "gpu/Scope.h"
#include "render/passes/Pass.h"

namespace velum::render {

namespace {

constexpr std::size_t kMostHandedOver = 2;
constexpr double kLongestWaitMs = 30e3;  // a driver that takes longer has hung: the next call of GL says so

}  // namespace

void WorkQueue::restart() {
  mSteps.clear();
  mCount = 0;
  mTimes.clear();
  mLongest = 0;
  ++mFrame;
}

WorkQueue::RunAgain WorkQueue::once(Run run) {
  return [run = std::move(run)] {
    run();
    return true;
  };
}

void WorkQueue::addUntilDone(Pass& pass, RunAgain run, Share done) {
  mSteps.push_back({pass.name(), &pass, std::move(run), std::move(done)});
}
void WorkQueue::add(Pass& pass, Run run) { addUntilDone(pass, once(std::move(run))); }
void WorkQueue::addUntilDone(const char* name, RunAgain run) { mSteps.push_back({name, nullptr, std::move(run), {}}); }
void WorkQueue::add(const char* name, Run run) { addUntilDone(name, once(std::move(run))); }

double WorkQueue::fractionDone() const {
  if (mCount == 0 || mSteps.empty()) return 1.0;
  double begun = mSteps.front().done ? mSteps.front().done() : 0.0;
  return std::max(0.0, 1.0 - (double(mSteps.size()) - begun) / double(mCount));  // pieces may be added later
}

bool WorkQueue::work(double budgetMs) {
  Clock::time_point start = Clock::now();
  // Time between calls is nobody's.
  mSince = start;
  for (mRests = false; !mSteps.empty() && !mRests;) {
    // A step may add others, or start the frame anew: it is not looked at where it lies.
    Step step = mSteps.front();
    {
      gpu::Scope scope(nullptr, step.name);
      if (step.run()) mSteps.pop_front();
    }
    mHandedOver.push_back({step.name, step.pass, mFrame, gpu::Fence(step.name)});
    // Some drivers have done a piece before they return; others are a piece behind.
    while (!mHandedOver.empty() && mHandedOver.front().fence.isSignalled()) retire();
    while (mHandedOver.size() >= kMostHandedOver) retire();
    if (msSince(start) >= budgetMs) break;
  }
  return mSteps.empty();
}

double WorkQueue::totalMs() const {
  double sum = 0;
  for (const auto& [name, ms] : mTimes) sum += ms;
  return sum;
}

void WorkQueue::finish() {
  mSince = Clock::now();
  while (!mHandedOver.empty()) retire();
}

/// Waits for the first that is with the driver. What it took is counted from when the one before it was done.
void WorkQueue::retire() {
  HandedOver& first = mHandedOver.front();
  first.fence.wait(kLongestWaitMs);
  double ms = msSince(mSince);
  mSince = Clock::now();
  if (first.frame == mFrame) {
    mTimes[first.name] += ms;
    mLongest = std::max(mLongest, ms);
    if (first.pass) first.pass->took(ms);
  }
  mHandedOver.pop_front();
}

}  // namespace velum::render
