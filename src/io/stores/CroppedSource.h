#pragma once
#include <memory>

#include "core/BrickCache.h"

namespace velum::io {

/// The voxels of a box of a level of another source, as a source of one level. Bricks that the box cuts are kept for
/// the next of its own bricks, within brickBudget().
class CroppedSource : public VoxelSource {
 public:
  /// @param box  inside the level @throw ArgumentError for one that is not
  CroppedSource(std::shared_ptr<const VoxelSource> source, const VoxelBox& box);
  const Volume& head() const override { return mHead; }
  void read(const BrickAddress& address, const SampleTarget& target) const override;

 private:
  VoxelBox mBox;
  Volume mHead;
  std::unique_ptr<BrickCache> mBricks;
};

}  // namespace velum::io
