#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "core/ReplaceFile.h"
#include "core/Volume.h"
#include "io/read/Refuse.h"

/// Packs what stores of Zarr are made of.
namespace velum::io {

/// The bytes as one frame of zstd with a check sum of its content. Any thread.
Bytes packZstd(std::span<const std::byte> bytes, int level);

/// Writes a shard (`sharding_indexed`): bricks, one after another, then where each begins and its size, 64 bits each,
/// then the check sum (crc32c) of that.
/// @param bricks  packed, in the order of the index; an empty one is left out  @throw InputError
void writeShardFile(std::span<const Bytes> bricks, ReplaceFile& file);

/// True when a file is a shard of so many bricks, as far as its index and size tell. Any thread.
bool isWholeShard(const Path& path, std::size_t brickCount);

}  // namespace velum::io
