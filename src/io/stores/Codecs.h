#pragma once
#include <cstdint>
#include <span>
#include <string_view>

#include "core/Fields.h"
#include "core/Volume.h"
#include "io/read/Refuse.h"

/// What packs the bytes of a chunk.
namespace velum::io {

/// A codec from bytes to bytes. Inflate is gzip and zlib, which tell themselves apart. Of LZ4 each program frames the
/// blocks in its own way: Lz4 is numcodecs', Lz4Java that of N5, Lz4Hdf5 the filter of HDF5. Shuffle puts the first
/// bytes of all samples first, then the second ones.
enum class Codec { Inflate, Zstd, Lz4, Lz4Java, Lz4Hdf5, Blosc, Bzip2, Xz, Shuffle, Crc32c };

/// The most bytes of one chunk: libraries count them in 31 bits.
inline constexpr std::uint64_t kMostChunkBytes = (std::uint64_t(1) << 31) - 1024;

/// Unpacks bytes, by the codecs in reverse, into exactly so many. Nothing larger than these is ever allocated but for
/// what lies between two codecs.
/// @param codecs       as they packed
/// @param size         of the bytes before they were packed, at most kMostChunkBytes
/// @param path         of the chunk, for messages
/// @param sampleBytes  of one sample, for Shuffle
/// @throw InputError when the bytes are damaged or unpack to another size. Any thread.
Bytes unpackBytes(std::span<const Codec> codecs, Bytes packed, std::uint64_t size, const Path& path,
                  std::size_t sampleBytes = 1);

}  // namespace velum::io
