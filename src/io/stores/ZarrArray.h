#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/stores/Codecs.h"
#include "io/stores/Store.h"
#include "io/stores/ChunkType.h"

namespace velum::io {

/// What the metadata of a Zarr array says, version 2 or 3. Lists have an entry an axis, the slowest first.
struct ZarrArray {
  /// Chunks that hold smaller ones, each packed by itself (`sharding_indexed`).
  struct Shard {
    std::vector<Codec> indexCodecs;
    bool isIndexAtStart = false;
    bool isIndexBigEndian = false;
  };

  std::string key;                   ///< of the array in its store
  std::vector<std::uint64_t> shape;  ///< samples
  std::vector<std::uint64_t> chunk;  ///< samples of what has a key of its own: a chunk, or a shard
  std::vector<std::uint64_t> brick;  ///< samples of what is read at once: a chunk, or one of those in a shard
  std::vector<std::size_t> order;    ///< which axis is the slowest in a brick's bytes, and so on: from C, F, transpose
  ChunkType type;
  std::array<std::byte, 8> fill{};  ///< one sample, in the stored byte order
  std::vector<Codec> codecs;        ///< that packed each brick
  std::optional<Shard> shard;
  bool isFlatKey = false;         ///< keys are "0.1", and not "c/0/1", before the separator is considered
  char separator = '/';           ///< between a key's numbers
  std::vector<std::string> axes;  ///< names of the axes; empty where the array does not say
  std::string packing;            ///< for people: "blosc (zstd)"
};

/// Reads the metadata; nothing where there is no array of that key. What we cannot read, such as a codec, is refused by
/// its name. @throw InputError
std::optional<ZarrArray> readZarrArray(const Store& store, const std::string& key);

/// Bytes of a brick as it is stored, unpacked; at most kMostChunkBytes.
std::uint64_t brickBytes(const ZarrArray& array);

/// The key of a chunk. @param index  of the chunk along each axis
std::string chunkKey(const ZarrArray& array, std::span<const std::uint64_t> index);

}  // namespace velum::io
