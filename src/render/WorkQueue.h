#pragma once
#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <string>

#include "core/Clock.h"
#include "gpu/Fence.h"

namespace velum::render {

class Pass;

/// The pieces of a frame's work in their order. At most two pieces are with the driver at a time: while it draws one,
/// the next is handed over. GL thread.
class WorkQueue {
 public:
  /// A piece of work that returns false when it wants to be called again.
  using RunAgain = std::function<bool()>;
  using Run = std::function<void()>;
  using Share = std::function<double()>;

  /// Forgets all pieces that have not begun, and all times; for a new frame.
  void restart();
  void add(Pass& pass, Run run);
  /// @param done  returns how much of the piece is done, 0..1; by default it counts as 0 until all of it is done
  void addUntilDone(Pass& pass, RunAgain run, Share done = {});
  /// Adds work that belongs to no pass, under a literal name.
  void add(const char* name, Run run);
  void addUntilDone(const char* name, RunAgain run);
  /// Called by a piece: forgets all pieces after it.
  void dropRest() { mSteps.erase(mSteps.begin() + 1, mSteps.end()); }
  /// Tells that all pieces of the frame have been added, so that fractionDone() counts from here.
  void countAll() { mCount = mSteps.size(); }

  bool isEmpty() const { return mSteps.empty(); }
  double fractionDone() const;
  /// Called by a piece: work() then returns before the next piece, whatever is left of its time.
  void rest() { mRests = true; }
  /// Works for about that long, at least one piece. @return true when all pieces have been handed over
  bool work(double budgetMs);
  /// Waits until the driver has done all that was handed over.
  void finish();

  /// Times, by name, of those pieces of this frame that the driver has finished.
  const std::map<std::string, double>& timesMs() const { return mTimes; }
  double totalMs() const;
  double longestMs() const { return mLongest; }

 private:
  struct Step {
    const char* name;
    Pass* pass;  ///< nullptr: the step belongs to no pass
    RunAgain run;
    Share done;
  };
  struct HandedOver {
    const char* name;
    Pass* pass;
    int frame;
    gpu::Fence fence;
  };
  static RunAgain once(Run run);
  void retire();

  std::deque<Step> mSteps;
  std::size_t mCount = 0;
  bool mRests = false;
  std::deque<HandedOver> mHandedOver;
  int mFrame = 0;  ///< Counts restarts: tells pieces of earlier frames, still with the driver, from this frame's.
  Clock::time_point mSince;  ///< When the driver began with the first of the pieces that are with it.
  std::map<std::string, double> mTimes;
  double mLongest = 0;
};

}  // namespace velum::render
