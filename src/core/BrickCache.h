#pragma once
#include <cstdint>
#include <future>
#include <list>
#include <memory>
#include <mutex>
#include <unordered_map>

#include "core/VoxelSource.h"

namespace velum {

/// A box of voxels of one level.
struct VoxelBox {
  int level = 0;
  glm::ivec3 origin{0}, size{0};  ///< may reach beyond the level: there its outermost voxels repeat
};

/// The bricks of a source that were asked for last, in memory, within a budget. Whoever asks for one that is not there
/// reads it on his own thread; who asks for the same one meanwhile waits for it. Any thread.
class BrickCache {
 public:
  /// The samples of a brick, laid out as Volume::voxels of its box.
  using Brick = std::shared_ptr<const Bytes>;

  /// @param mostBytes  of all bricks that are kept
  BrickCache(std::shared_ptr<const VoxelSource> source, std::size_t mostBytes);

  const VoxelSource& source() const { return *mSource; }

  /// A brick, read where it is not there. @throw InputError when it cannot be read, each time anew
  Brick brick(const BrickAddress& address);
  /// A brick if it is there.
  Brick find(const BrickAddress& address);

  /// A volume of the voxels of a box, one channel or all, at one time step; its place and range are those of the
  /// source's head. @param channel  -1: all. @throw InputError when a brick cannot be read
  Volume read(const VoxelBox& box, int channel, int timeStep);
  /// True when read() of the box would wait for no disk.
  bool has(const VoxelBox& box, int channel, int timeStep);

  std::size_t bytes() const;
  std::size_t mostBytes() const;
  /// Another budget; what is beyond it goes at once.
  void setMostBytes(std::size_t mostBytes);

 private:
  using Key = std::uint64_t;
  struct Kept {
    std::shared_future<Brick> brick;
    std::size_t bytes = 0;  ///< 0 while it is being read
    std::list<Key>::iterator use;
  };
  Key keyOf(const BrickAddress& address) const;
  Brick readBrick(const BrickAddress& address) const;
  void keep(Key key, std::size_t bytes);
  void dropBeyondBudget(const Key* keeps);

  std::shared_ptr<const VoxelSource> mSource;
  std::size_t mMostBytes;
  mutable std::mutex mMutex;
  std::unordered_map<Key, Kept> mKept;
  std::list<Key> mUses;  ///< those used last come first
  std::size_t mBytes = 0;
};

/// What a volume that is a coarse level of a source knows of the finer ones.
struct FinerLevels {
  std::shared_ptr<BrickCache> bricks;
  int level = 0;  ///< of the volume itself
};

/// Where a level of the source that a volume is a level of lies in the volume's world, as it stands there: in its unit,
/// with its spacing, which may be other than the file's.
/// @param volume  with finer levels
glm::dmat4 worldFromLevel(const Volume& volume, int level);

/// A voxel may be so many pixels wide before a finer level is wanted: halfway between two levels.
inline constexpr double kVoxelsPerPixel = 1.42;
/// The level of a volume with finer levels whose voxels are about as large as a pixel, down to its own.
/// @param pixel  length of its edge, world
int levelForPixel(const Volume& volume, double pixel);
/// Length of the smallest edge of a voxel, world.
double smallestSpacing(const glm::dmat4& worldFromVoxel);

/// Voxels along x, y, z and the edges of one, of the finest level that there is: the volume's own where it knows no
/// finer one.
glm::ivec3 finestDims(const Volume& volume);
glm::dvec3 finestSpacing(const Volume& volume);

}  // namespace velum
