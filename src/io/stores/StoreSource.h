#pragma once
#include <algorithm>
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
  std::vector<LabelInfo> structures;  ///< of labels: names and colours, as far as the file has some; where an id needs
                                      ///< more than 16 bits it is LabelInfo::fileId, and id is 0
  bool isAlignedByBorders = false;    ///< nothing says where coarser levels lie; they are taken as means of blocks
  std::vector<StoredLevel> levels;    ///< one for each of the source's
};

/// An image of a store of any format, level by level.
class StoreSource : public VoxelSource {
 public:
  const Volume& head() const override { return mHead; }
  const StoreFacts& facts() const { return mFacts; }

  /// From now on whole numbers of 64 bits, as ids of labels may be, are given as they are: the bits of each in a sample
  /// of as many bits, for which head() says Float64. Others, and those of levels of several types, stay as they were.
  /// Before the first read.
  void carryIds() {
    auto isWide = [](const StoredLevel& level) {
      return level.type.bytes == 8 && level.type.kind != ChunkType::Kind::Float;
    };
    mCarriesIds = std::all_of(mFacts.levels.begin(), mFacts.levels.end(), isWide);
    if (mCarriesIds) mHead.type = SampleType::Float64;
  }
  bool carriesIds() const { return mCarriesIds; }

 protected:
  /// The type that samples are brought from: their own, but the bits of ids that are carried are nobody's numbers.
  ChunkType givenType(ChunkType stored) const {
    if (mCarriesIds && stored.bytes == 8) stored.kind = ChunkType::Kind::Float;
    return stored;
  }
  Volume mHead;
  StoreFacts mFacts;
  bool mCarriesIds = false;
};

}  // namespace velum::io
