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

/// The pieces of a frame's work in their order. At most two of them are with the driver at a time: while it draws one,
/// the next is handed over. GL thread.
class WorkQueue {
 public:
  /// Returns false when it wants to be called again.
  using RunAgain = std::function<bool()>;
  using Run = std::function<void()>;
  using Share = std::function<double()>;

  /// Forgets what has not been begun, and all times: a new frame.
  void restart();
  void add(Pass& pass, Run run);
  /// @param done  how much of it is, 0..1; by default none until all of it is
  void addUntilDone(Pass& pass, RunAgain run, Share done = {});
  /// Work that is nobody's, by a literal name.
  void add(const char* name, Run run);
  void addUntilDone(const char* name, RunAgain run);
  /// The share of a frame that is done is counted from here: all of its pieces are known.
  void countAll() { mCount = mSteps.size(); }

  bool isEmpty() const { return mSteps.empty(); }
  double fractionDone() const;
  /// For a piece, about one that comes after it: work() returns before that, whatever is left of its time.
  void rest() { mRests = true; }
  /// Works for about that long, at least one piece. @return true when there is no more to hand over
  bool work(double budgetMs);
  /// Waits until the driver has done all that was handed over.
  void finish();

  /// Of this frame's pieces that the driver has said to be done, by name.
  const std::map<std::string, double>& timesMs() const { return mTimes; }
  double totalMs() const;
  double longestMs() const { return mLongest; }

 private:
  struct Step {
    const char* name;
    Pass* pass;  ///< nullptr: nobody's
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
  int mFrame = 0;            ///< Counts restarts: what is still with the driver from before is not this frame's.
  Clock::time_point mSince;  ///< When the driver began with the first that is with it.
  std::map<std::string, double> mTimes;
  double mLongest = 0;
};

}  // namespace velum::render
