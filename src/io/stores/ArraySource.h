#pragma once
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>
#include <vector>

#include "io/stores/ChunkArray.h"
#include "io/stores/StoreSource.h"

namespace velum::io {

/// Opens one of the arrays of a pyramid; null where there is none, which means that all of its samples are 0.
/// @throw InputError
using ArrayOpener = std::function<std::shared_ptr<const ChunkArray>(int level, int channel, int timeStep)>;

/// An image that lies in arrays.
struct ArrayPyramid {
  Volume head;  ///< without voxels; dims, type and place are those of the finest level
  std::vector<VoxelLevel> levels;
  std::vector<glm::dvec2> channelWindows;  ///< empty, or one a channel
  StoreFacts facts;
  bool isWhole = false;  ///< an array holds all channels and time steps of a level; otherwise one of each
  ArrayOpener open;
};

/// A level of an array: its dims, brick and how it is stored, without its place. @param dims  voxels that count, of an
/// array that is padded; {0, 0, 0}: all of them @throw InputError
VoxelLevel levelOf(const ChunkArray& array, glm::ivec3 dims = glm::ivec3(0));
StoredLevel storedAs(const ChunkArray& array, std::string key);

/// An image that lies in an array a level, or an array for each channel and time step of a level. Arrays are opened
/// when they are first read.
class ArraySource : public StoreSource {
 public:
  explicit ArraySource(ArrayPyramid pyramid);
  void read(const BrickAddress& address, const SampleTarget& target) const override;

 private:
  std::shared_ptr<const ChunkArray> arrayOf(const BrickAddress& address) const;
  void check(const ChunkArray& array, int level) const;

  bool mIsWhole;
  ArrayOpener mOpen;
  mutable std::mutex mGuard;
  mutable std::map<std::tuple<int, int, int>, std::shared_ptr<const ChunkArray>> mArrays;  ///< those that are open
};

}  // namespace velum::io
