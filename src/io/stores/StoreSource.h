#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/LabelVolume.h"
#include "core/VoxelSource.h"
#include "io/stores/ChunkType.h"

namespace velum::io {

/// The most levels of an image that make sense.
inline constexpr std::size_t kMostLevels = 62;

/// How a level is stored, for people.
struct StoredLevel {
  std::string key;  ///< of the array, or of the first of several
  ChunkType type;
  std::vector<std::uint64_t> chunk;  ///< samples of what is unpacked at once, the slowest axis first
  std::vector<std::uint64_t> shard;  ///< of the file that holds several; empty: none does
  std::string packing;               ///< "blosc (zstd)"
};

/// What a store tells of an image beyond a source's own words.
struct StoreFacts {
  std::string axes;                   ///< names, the slowest first: "t c z y x"
  std::string unit;                   ///< of lengths, as the file says; empty: it does not
  bool isLabels = false;              ///< samples are ids
  std::vector<LabelInfo> structures;  ///< of labels: names and colours of ids, as far as the file has some
  bool isAlignedByBorders = false;    ///< nothing says where coarser levels lie; they are taken as means of blocks
  std::vector<StoredLevel> levels;    ///< one for each of the source's
};

/// An image of a store of any format, level by level.
class StoreSource : public VoxelSource {
 public:
  const Volume& head() const override { return mHead; }
  const StoreFacts& facts() const { return mFacts; }

 protected:
  Volume mHead;
  StoreFacts mFacts;
};

}  // namespace velum::io
