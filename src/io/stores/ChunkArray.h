#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/Volume.h"
#include "io/read/Refuse.h"
#include "io/stores/ChunkType.h"

namespace velum::io {

/// Numbers along x, y, z, channels and time.
using FiveSizes = std::array<std::uint64_t, 5>;

/// An array in chunks, each of which is unpacked by itself. Any thread, several at a time.
class ChunkArray {
 public:
  virtual ~ChunkArray() = default;

  /// Samples of a chunk as they are stored, x fastest, then y, z, channels, time.
  struct Chunk {
    Bytes bytes;
    FiveSizes size{};  ///< samples: of chunks at the far borders fewer may be there
  };
  /// A chunk; nothing where it is missing, which means that all of its samples are 0.
  /// @param index  of the chunk along each axis @throw InputError
  virtual std::optional<Chunk> read(const FiveSizes& index) const = 0;

  FiveSizes size{1, 1, 1, 1, 1}, chunk{1, 1, 1, 1, 1};
  ChunkType type;
  std::string packing;
  Path path;  ///< for messages
};

/// Checks that sizes, and what a chunk unpacks to, make sense. @throw InputError
void checkSizes(const ChunkArray& array);

/// The packing's name for people: "gzip", "shuffle, lz4".
std::string packingOf(const std::vector<std::string>& names);

}  // namespace velum::io
