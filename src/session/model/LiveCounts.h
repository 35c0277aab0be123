#pragma once
#include <cstdint>
#include <vector>

#include "core/Shared.h"
#include "render/Counts.h"

namespace velum::session {

/// Counts of a picture that is drawn over and over, by type and compartment: exact where the picture is complete. While
/// something moves pictures are coarse, and fewer instances have a pixel in them: how many more the complete picture
/// showed of each type, when there was last one of each, is taken for how many more it would show now.
class LiveCounts {
 public:
  /// @param isComplete  the picture is the one that stays; else a coarse one
  void take(const Shared<Model>& model, const render::InstanceBits& bits, bool isComplete);
  void clear() { *this = {}; }

  /// Null before there are any.
  const Shared<Model>& model() const { return mModel; }
  bool isExact() const { return mIsExact; }
  /// By their places in the model; visible + hidden + clipped is all there are.
  const std::vector<Counts>& types() const { return mTypes; }
  const std::vector<Counts>& compartments() const { return mCompartments; }

 private:
  Shared<Model> mModel;
  bool mIsExact = false;
  std::vector<Counts> mTypes, mCompartments;
  std::vector<std::uint64_t> mCoarse;  ///< Visible ones of the last coarse picture, by type.
  std::vector<double> mFactors;        ///< Of complete pictures to coarse ones.
};

}  // namespace velum::session
