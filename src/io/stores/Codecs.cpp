#include "io/stores/Codecs.h"

#include <blosc.h>
#include <fmt/format.h>
#include <lz4.h>
#include <zlib.h>
#include <zstd.h>

#include <cstring>

#include "io/stores/Crc32c.h"

namespace velum::io {

namespace {

[[noreturn]] void refuseDamaged(const Path& path, std::string_view codec) {
  refuse(path, fmt::format("its {} bytes are damaged, or unpack to more than the chunk holds", codec));
}

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

/// As numcodecs writes it: the size, 32 bits, then one block.
Bytes unpackLz4(std::span<const std::byte> from, std::uint64_t most, const Path& path) {
  std::uint32_t promised = 0;
  if (from.size() < sizeof(promised)) refuseDamaged(path, "lz4");
  std::memcpy(&promised, from.data(), sizeof(promised));
  if (promised > most) refuseDamaged(path, "lz4");
  Bytes bytes(promised);
  int size =
      ::LZ4_decompress_safe(reinterpret_cast<const char*>(from.data() + sizeof(promised)),
                            reinterpret_cast<char*>(bytes.data()), int(from.size() - sizeof(promised)), int(promised));
  if (size != int(promised)) refuseDamaged(path, "lz4");
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

Bytes unpack(Codec codec, Bytes packed, std::uint64_t most, const Path& path) {
  switch (codec) {
    case Codec::Inflate:
      return inflateBytes(packed, most, path);
    case Codec::Zstd:
      return unpackZstd(packed, most, path);
    case Codec::Lz4:
      return unpackLz4(packed, most, path);
    case Codec::Blosc:
      return unpackBlosc(packed, most, path);
    case Codec::Crc32c:
      break;
  }
  return checkCrc(std::move(packed), path);
}

}  // namespace

Bytes unpackBytes(std::span<const Codec> codecs, Bytes packed, std::uint64_t size, const Path& path) {
  constexpr std::uint64_t kSlack = 1u << 16;  // what packing may add
  for (std::size_t left = codecs.size(); left-- > 0;) {
    std::uint64_t most = left == 0 ? size : size + size / 8 + kSlack;
    packed = unpack(codecs[left], std::move(packed), most, path);
  }
  if (packed.size() != size)
    refuse(path, fmt::format("holds {} bytes of samples, where a chunk has {}", packed.size(), size));
  return packed;
}

}  // namespace velum::io
