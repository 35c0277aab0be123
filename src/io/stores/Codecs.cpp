#include "io/stores/Codecs.h"

#include <blosc.h>
#include <bzlib.h>
#include <fmt/format.h>
#include <lzma.h>
#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <cstring>

#include "io/stores/Crc32c.h"
#include "io/stores/Lz4Frames.h"

namespace velum::io {

namespace {

/// gzip, of one member or several, or zlib.
Bytes inflateBytes(std::span<const std::byte> from, std::uint64_t most, const Path& path) {
  Bytes bytes(static_cast<std::size_t>(most));
  z_stream stream{};
  if (::inflateInit2(&stream, MAX_WBITS + 32) != Z_OK) refuse(path, "there is no memory to inflate it");
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(from.data()));
  stream.avail_in = uInt(from.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = uInt(bytes.size());
  int result;
  do {
    result = ::inflate(&stream, Z_FINISH);
  } while (result == Z_STREAM_END && stream.avail_in > 0 && ::inflateReset(&stream) == Z_OK);
  bytes.resize(bytes.size() - stream.avail_out);
  ::inflateEnd(&stream);
  if (result != Z_STREAM_END) refuseDamaged(path, "deflated");
  return bytes;
}

Bytes unpackZstd(std::span<const std::byte> from, std::uint64_t most, const Path& path) {
  auto promised = ::ZSTD_getFrameContentSize(from.data(), from.size());
  bool isUnknown = promised == ZSTD_CONTENTSIZE_UNKNOWN;
  if (promised == ZSTD_CONTENTSIZE_ERROR || (!isUnknown && promised > most)) refuseDamaged(path, "zstd");
  Bytes bytes(static_cast<std::size_t>(most));
  std::size_t size = ::ZSTD_decompress(bytes.data(), bytes.size(), from.data(), from.size());
  if (::ZSTD_isError(size)) refuseDamaged(path, "zstd");
  bytes.resize(size);
  return bytes;
}

/// Calls step with a stream until all is unpacked or nothing more fits. @return whether the stream came to its end
template <class Stream>
bool unpackStream(Stream& stream, std::span<const std::byte> from, Bytes& to, auto&& step) {
  stream.next_in = reinterpret_cast<decltype(stream.next_in)>(const_cast<std::byte*>(from.data()));
  stream.avail_in = static_cast<decltype(stream.avail_in)>(from.size());
  stream.next_out = reinterpret_cast<decltype(stream.next_out)>(to.data());
  stream.avail_out = static_cast<decltype(stream.avail_out)>(to.size());
  bool isWhole = step(stream);
  to.resize(to.size() - stream.avail_out);
  return isWhole;
}

Bytes unpackBzip2(std::span<const std::byte> from, std::uint64_t most, const Path& path) {
  bz_stream stream{};
  if (::BZ2_bzDecompressInit(&stream, 0, 0) != BZ_OK) refuse(path, "there is no memory to unpack it");
  Bytes bytes(static_cast<std::size_t>(most));
  bool isWhole =
      unpackStream(stream, from, bytes, [](bz_stream& of) { return ::BZ2_bzDecompress(&of) == BZ_STREAM_END; });
  ::BZ2_bzDecompressEnd(&stream);
  if (!isWhole) refuseDamaged(path, "bzip2");
  return bytes;
}

Bytes unpackXz(std::span<const std::byte> from, std::uint64_t most, const Path& path) {
  constexpr std::uint64_t kMostMemory = std::uint64_t(256) << 20;  // what the highest level needs, and more
  lzma_stream stream = LZMA_STREAM_INIT;
  if (::lzma_auto_decoder(&stream, kMostMemory, 0) != LZMA_OK) refuse(path, "there is no memory to unpack it");
  Bytes bytes(static_cast<std::size_t>(most));
  bool isWhole = unpackStream(stream, from, bytes,
                              [](lzma_stream& of) { return ::lzma_code(&of, LZMA_FINISH) == LZMA_STREAM_END; });
  ::lzma_end(&stream);
  if (!isWhole) refuseDamaged(path, "xz");
  return bytes;
}

Bytes unshuffle(const Bytes& from, std::size_t sampleBytes) {
  Bytes bytes(from.size());
  std::size_t count = from.size() / sampleBytes;
  for (std::size_t part = 0; part < sampleBytes; ++part)
    for (std::size_t i = 0; i < count; ++i) bytes[i * sampleBytes + part] = from[part * count + i];
  std::copy(from.begin() + std::ptrdiff_t(count * sampleBytes), from.end(),
            bytes.begin() + std::ptrdiff_t(count * sampleBytes));  // what is left over is no sample
  return bytes;
}

Bytes unpackBlosc(std::span<const std::byte> from, std::uint64_t most, const Path& path) {
  std::size_t promised = 0;
  if (::blosc_cbuffer_validate(from.data(), from.size(), &promised) != 0 || promised > most)
    refuseDamaged(path, "blosc");
  Bytes bytes(promised);
  int size = ::blosc_decompress_ctx(from.data(), bytes.data(), bytes.size(), 1);
  if (size < 0 || std::size_t(size) != promised) refuseDamaged(path, "blosc");
  return bytes;
}

Bytes checkCrc(Bytes bytes, const Path& path) {
  std::uint32_t stored = 0;
  if (bytes.size() < sizeof(stored)) refuse(path, "is too short for its check sum");
  std::size_t size = bytes.size() - sizeof(stored);
  std::memcpy(&stored, bytes.data() + size, sizeof(stored));
  bytes.resize(size);
  if (crc32c(bytes) != stored) refuse(path, "its check sum (crc32c) is wrong: it is damaged");
  return bytes;
}

Bytes unpack(Codec codec, Bytes packed, std::uint64_t most, const Path& path, std::size_t sampleBytes) {
  switch (codec) {
    case Codec::Inflate:
      return inflateBytes(packed, most, path);
    case Codec::Zstd:
      return unpackZstd(packed, most, path);
    case Codec::Lz4:
      return unpackLz4(packed, most, path);
    case Codec::Lz4Java:
      return unpackLz4Java(packed, most, path);
    case Codec::Lz4Hdf5:
      return unpackLz4Hdf5(packed, most, path);
    case Codec::Blosc:
      return unpackBlosc(packed, most, path);
    case Codec::Bzip2:
      return unpackBzip2(packed, most, path);
    case Codec::Xz:
      return unpackXz(packed, most, path);
    case Codec::Shuffle:
      return sampleBytes > 1 ? unshuffle(packed, sampleBytes) : std::move(packed);
    case Codec::Crc32c:
      break;
  }
  return checkCrc(std::move(packed), path);
}

}  // namespace

Bytes unpackBytes(std::span<const Codec> codecs, Bytes packed, std::uint64_t size, const Path& path,
                  std::size_t sampleBytes) {
  constexpr std::uint64_t kSlack = 1u << 16;  // what packing may add
  for (std::size_t left = codecs.size(); left-- > 0;) {
    std::uint64_t most = left == 0 ? size : size + size / 8 + kSlack;
    packed = unpack(codecs[left], std::move(packed), most, path, sampleBytes);
  }
  if (packed.size() != size)
    refuse(path, fmt::format("holds {} bytes of samples, where a chunk has {}", packed.size(), size));
  return packed;
}

}  // namespace velum::io
