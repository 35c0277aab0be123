#pragma once
#include "core/VoxelSource.h"

namespace velum::io {

/// Labels in voxels twice as long along each axis as those of a level of another source: each has the id that most of
/// its eight have (Reduction::Majority). Of the first channel and time step.
class HalvedSource : public VoxelSource {
 public:
  /// @param finer  must outlive this
  HalvedSource(const VoxelSource& finer, int level);
  const Volume& head() const override { return mHead; }
  void read(const BrickAddress& address, const SampleTarget& target) const override;
  /// {0, 0} where all bricks below are known to be 0.
  std::optional<glm::dvec2> range(const BrickAddress& address) const override;

 private:
  /// Calls body(address) for the finer bricks of a brick.
  template <class Body>
  void forFiner(glm::ivec3 brick, const Body& body) const;
  const VoxelSource& mFiner;
  int mLevel;
  Volume mHead;
};

}  // namespace velum::io
