#pragma once
#include <cstddef>
#include <memory>

#include "core/BrickCache.h"
#include "core/Task.h"
#include "core/Volume.h"

namespace velum {

/// Samples of one channel that lie one after the other along x.
struct SampleRun {
  const void* samples = nullptr;  ///< of the volume's type
  std::size_t first = 0;          ///< number of the run's first sample among them
  int stride = 1;                 ///< samples from one voxel to the next
  int count = 0;                  ///< voxels
  BrickCache::Brick kept;         ///< keeps a brick alive while its samples are looked at
};

/// The voxels of a volume in its finest level, wherever they are: in memory, or in bricks, which are read as they are
/// asked for, on the thread that asks. Any thread; copies are cheap.
class FinestVoxels {
 public:
  /// @param volume  must outlive this
  /// @param level  of a streamed volume: which level is meant in place of the finest
  explicit FinestVoxels(const Volume& volume, int level = 0);
  explicit FinestVoxels(Volume&&, int level = 0) = delete;

  /// All that is known of the level but its voxels: its dims, its place, its unit. Where the volume is in memory
  /// as a whole, the volume itself.
  const Volume& grid() const { return *mGrid; }
  /// True where voxels are read brick by brick, so that it costs to look at those that nobody needs.
  bool isStreamed() const { return mBricks != nullptr; }

  /// A sample as a value, with the result that valueAt() has of a volume in memory.
  /// @param voxel  indices inside grid().dims; not checked @throw InputError when its brick cannot be read
  double value(glm::ivec3 voxel, int channel = 0, int timeStep = 0) const;
  /// The same for a hand that points at something; NaN where the brick cannot be read, which whoever grows there will
  /// say.
  double valueOrNan(glm::ivec3 voxel, int channel = 0, int timeStep = 0) const;
  /// The samples from a voxel on along x, as far as they lie together: to the end of the row, or of the voxel's brick.
  /// @throw InputError when the brick cannot be read
  SampleRun run(glm::ivec3 voxel, int channel, int timeStep) const;
  /// A volume of the voxels of a box, one channel or all, at one time step: with its place and the range of the whole.
  /// @param first, size  the box, of which what lies in the grid is taken @param channel  -1: all
  /// @throw InputError when a brick cannot be read
  Volume read(glm::ivec3 first, glm::ivec3 size, int channel, int timeStep) const;
  /// The same of a large box, on all cores. @throw Cancelled, too
  Volume readAll(glm::ivec3 first, glm::ivec3 size, int channel, int timeStep, Progress& progress) const;

 private:
  void describe(Volume& part, glm::ivec3 first, int channel) const;
  const Volume* mGrid;
  std::shared_ptr<const Volume> mHead;  ///< of what is streamed
  BrickCache* mBricks = nullptr;
  int mLevel = 0;
};

}  // namespace velum
