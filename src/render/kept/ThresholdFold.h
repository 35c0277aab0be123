#pragma once
#include <algorithm>

#include "shared/cuts.h"

namespace velum::render {

/// As shared::CutFold, but joins thresholds instead of answers. A threshold is the number from which on a cut leaves a
/// thing. Where all cuts must leave it the largest threshold counts; where one cut is enough, the least.
class ThresholdFold {
 public:
  /// @param always, never  numbers below, and above, all thresholds
  ThresholdFold(float always, float never) : mAlways(always), mBefore(always), mLast(always), mInlay(never) {}

  /// @param part  shared::cutPart()
  void add(int part, float threshold) {
    if (part == shared::kFoldInlay) {
      mHasInlay = true;
      mInlay = std::min(mInlay, threshold);
    } else if (part == shared::kFoldJoined) {
      mLast = std::min(mLast, threshold);
    } else {
      mBefore = std::max(mBefore, mLast);
      mLast = threshold;
    }
  }
  float threshold() const { return std::max({mBefore, mLast, mHasInlay ? mInlay : mAlways}); }

 private:
  float mAlways, mBefore, mLast, mInlay;
  bool mHasInlay = false;
};

}  // namespace velum::render
