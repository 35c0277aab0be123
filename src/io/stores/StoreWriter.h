#pragma once
#include <functional>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "io/stores/ReadBox.h"
#include "io/stores/WriteStore.h"
#include "io/stores/ZarrSource.h"

namespace velum::io {

/// Writes the arrays of a store into a folder, level by level, shard by shard; what is there already stays.
class StoreWriter {
 public:
  /// @param source, progress  must outlive the writer  @param head  of the source, at the level that is written
  StoreWriter(const VoxelSource& source, Volume head, Path folder, const StoreOptions& options, Progress& progress);

  /// Makes the folder or takes up one that was left, whose plan must be the same. @throw InputError
  void begin();
  /// @throw InputError, Cancelled
  void writeLevels();
  /// Between which values each channel lies in the coarsest level, or as the source says.
  std::vector<glm::dvec2> findWindows() const;
  /// Metadata of the image, with which the store can be read once the mark is removed.
  void describe(const std::vector<glm::dvec2>& windows);

  const OmeLayout& layout() const { return mLayout; }

 private:
  /// Which shard, along time and channels, and along x, y, z.
  struct Place {
    int timeStep = 0, channel = 0;
    glm::ivec3 shard{0};
  };
  /// Gives the samples of a box of one channel and time step, x fastest.
  using Fill = std::function<void(const BrickBox& box, Bytes& samples)>;

  std::string planText() const;
  std::uint32_t fingerprint() const;
  void writeFinest();
  void writeSlab(BrickBox slab);
  void writeCoarser(int level);
  void reduceInto(Bytes& samples, const VoxelSource& finer, const PlannedLevel& level, const BrickBox& box) const;
  void writeShard(int level, const Place& place, const Fill& fill);
  Bytes packedBrick(int level, const BrickBox& box, const Fill& fill) const;
  bool isThere(int level, const Place& place) const;
  Path shardPath(int level, const Place& place) const;
  Path brickPath(int level, const Place& place, std::size_t brick) const;
  Path chunkPath(int level, int timeStep, int channel, glm::ivec3 index) const;
  void writeFile(const Path& path, std::span<const std::byte> bytes) const;
  /// A level as it was written.
  ZarrSource written(int level) const;
  void tellShard(int level, glm::ivec3 voxels);

  const VoxelSource& mSource;
  Volume mHead;
  Path mFolder;
  StoreOptions mOptions;
  OmeLayout mLayout;
  Progress& mProgress;
  bool mResumes = false;
  Bytes mSlab;          ///< samples of the finest level
  double mTotal = 0.0;  ///< voxels to write, over channels, time steps and levels
  std::mutex mTelling;
  double mDone = 0.0;
};

/// Makes a folder and those it lies in. @throw InputError
void makeFolders(const Path& folder);

}  // namespace velum::io
