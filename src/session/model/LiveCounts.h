#pragma once
#include <cstdint>
#include <vector>

#include "core/Shared.h"
#include "render/Counts.h"

namespace velum::session {

/// Counts of a picture that is drawn over and over, by type and compartment: exact where the picture is complete. While
/// something moves pictures are coarse, and fewer instances have a pixel in them. Their counts are then scaled, for
/// each type, by the ratio of complete to coarse when there was last a picture of each kind.
class LiveCounts {
 public:
  /// @param bits  what became of the instances in the picture
  /// @param isComplete  the picture is the one that stays; false: a coarse picture
  void take(const Shared<Model>& model, const render::InstanceBits& bits, bool isComplete);
  void clear() { *this = {}; }

  /// The model that was counted; null before the first picture.
  const Shared<Model>& model() const { return mModel; }
  bool isExact() const { return mIsExact; }
  /// Counts by the place of types and compartments in the model; visible + hidden + clipped is the number of all
  /// instances.
  const std::vector<Counts>& types() const { return mTypes; }
  const std::vector<Counts>& compartments() const { return mCompartments; }

 private:
  Shared<Model> mModel;
  bool mIsExact = false;
  std::vector<Counts> mTypes, mCompartments;
  std::vector<std::uint64_t> mCoarse;  ///< Visible instances in the last coarse picture, by type.
  std::vector<double> mFactors;        ///< Visible instances of complete pictures by those of coarse ones, by type.
};

}  // namespace velum::session
