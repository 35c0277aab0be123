#include "io/stores/ZarrCodecs.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace velum::io {

namespace {

/// Names of codecs in both versions.
std::optional<Codec> codecOf(std::string_view name) {
  if (name == "gzip" || name == "zlib") return Codec::Inflate;
  if (name == "zstd") return Codec::Zstd;
  if (name == "lz4") return Codec::Lz4;
  if (name == "blosc") return Codec::Blosc;
  if (name == "crc32c") return Codec::Crc32c;
  return std::nullopt;
}

[[noreturn]] void refuseCodec(const Path& path, std::string_view name) {
  refuse(path, fmt::format("its chunks are packed by the codec {}, which is not known here; gzip, zlib, zstd, lz4, "
                           "blosc, crc32c, transpose and sharding_indexed are",
                           inQuotes(name)));
}

void addPacking(ZarrArray& array, std::string_view name, const Json& settings) {
  std::string within = wordOf(memberOf(settings, "cname"));
  array.packing +=
      (array.packing.empty() ? "" : ", ") + std::string(name) + (within.empty() ? "" : " (" + within + ")");
}

bool isBigEndian(const Json& settings, const Path& path) {
  std::string endian = wordOf(memberOf(settings, "endian"));
  if (!endian.empty() && endian != "little" && endian != "big")
    refuse(path, fmt::format("the byte order {} is not known", inQuotes(endian)));
  return endian == "big";
}

/// array -> array: which axis of the array is the slowest in what is packed, and so on.
void applyTranspose(ZarrArray& array, const Json& settings, const Path& path) {
  const Json& order = memberOf(settings, "order");
  std::vector<std::size_t> axes = array.order, seen(axes.size(), 0);
  if (order == "C") return;
  if (order == "F") {
    std::reverse(array.order.begin(), array.order.end());
    return;
  }
  bool isFit = order.is_array() && order.size() == axes.size();
  for (std::size_t i = 0; isFit && i < axes.size(); ++i) {
    isFit = order[i].is_number_unsigned() && order[i].get<std::uint64_t>() < axes.size() &&
            seen[order[i].get<std::size_t>()]++ == 0;
    if (isFit) axes[i] = array.order[order[i].get<std::size_t>()];
  }
  if (!isFit) refuse(path, "the codec 'transpose' gives no order of the array's axes");
  array.order = axes;
}

/// The codecs of a shard's index, of which only check sums leave its place known.
void readIndexCodecs(ZarrArray::Shard& shard, const Json& codecs, const Path& path) {
  if (!codecs.is_array()) refuse(path, "the shards' index has no codecs");
  bool hasBytes = false;
  for (const Json& codec : codecs) {
    std::string name = extensionName(codec);
    if (name == "bytes" && !hasBytes) {
      hasBytes = true;
      shard.isIndexBigEndian = isBigEndian(memberOf(codec, "configuration"), path);
    } else if (name == "crc32c" && hasBytes) {
      shard.indexCodecs.push_back(Codec::Crc32c);
    } else {
      refuse(path, fmt::format("the shards' index is packed by the codec {}, which is not known here", inQuotes(name)));
    }
  }
  if (!hasBytes) refuse(path, "the shards' index lacks the codec 'bytes'");
}

void readShard(ZarrArray& array, const Json& settings, const Path& path) {
  if (array.shard) refuse(path, "it has shards within shards, which are not known here");
  bool isStraight = std::is_sorted(array.order.begin(), array.order.end());
  if (!isStraight) refuse(path, "its shards are transposed as a whole, which is not known here");
  array.brick = sizesOf(memberOf(settings, "chunk_shape"), path, "the chunk_shape of the shards");
  bool isFit = array.brick.size() == array.chunk.size();
  for (std::size_t i = 0; isFit && i < array.brick.size(); ++i) isFit = array.chunk[i] % array.brick[i] == 0;
  if (!isFit) refuse(path, "the chunks in its shards do not divide the shards");
  ZarrArray::Shard shard;
  std::string location = wordOf(memberOf(settings, "index_location"));
  if (!location.empty() && location != "end" && location != "start")
    refuse(path, fmt::format("the place {} of the shards' index is not known", inQuotes(location)));
  shard.isIndexAtStart = location == "start";
  readIndexCodecs(shard, memberOf(settings, "index_codecs"), path);
  array.shard = shard;
  readCodecs(array, memberOf(settings, "codecs"), path);
}

}  // namespace

std::string extensionName(const Json& value) {
  return value.is_string() ? wordOf(value) : wordOf(memberOf(value, "name"));
}

std::vector<std::uint64_t> sizesOf(const Json& value, const Path& path, std::string_view what) {
  constexpr std::uint64_t kMost = std::uint64_t(1) << 62;
  constexpr std::size_t kMostAxes = 32;
  if (!value.is_array() || value.size() > kMostAxes) refuse(path, fmt::format("{} is no list of sizes", what));
  std::vector<std::uint64_t> sizes;
  for (const Json& item : value) {
    bool isSize = item.is_number_unsigned() && item.get<std::uint64_t>() >= 1 && item.get<std::uint64_t>() <= kMost;
    if (!isSize) refuse(path, fmt::format("{} holds something that is no size", what));
    sizes.push_back(item.get<std::uint64_t>());
  }
  return sizes;
}

void readCompressor(ZarrArray& array, const Json& metadata, const Path& path) {
  const Json& filters = memberOf(metadata, "filters");
  if (filters.is_array() && !filters.empty())
    refuse(path, fmt::format("its samples are filtered by {}, which is not known here",
                             inQuotes(wordOf(memberOf(filters.front(), "id")))));
  const Json& compressor = memberOf(metadata, "compressor");
  if (compressor.is_null()) {
    array.packing = "raw";
    return;
  }
  std::string name = wordOf(memberOf(compressor, "id"));
  auto codec = codecOf(name);
  if (!codec) refuseCodec(path, name);
  array.codecs.push_back(*codec);
  addPacking(array, name, compressor);
}

void readCodecs(ZarrArray& array, const Json& codecs, const Path& path) {
  constexpr std::size_t kMostCodecs = 16;
  if (!codecs.is_array() || codecs.empty() || codecs.size() > kMostCodecs) refuse(path, "it has no list of codecs");
  bool hasBytes = false;
  for (const Json& codec : codecs) {
    std::string name = extensionName(codec);
    const Json& settings = memberOf(codec, "configuration");
    bool isToBytes = name == "bytes" || name == "sharding_indexed";
    if (isToBytes && hasBytes) refuse(path, "two of its codecs make bytes of samples");
    if (name == "transpose" && !hasBytes) {
      applyTranspose(array, settings, path);
    } else if (name == "bytes") {
      array.type.isBigEndian = isBigEndian(settings, path);
    } else if (name == "sharding_indexed") {
      readShard(array, settings, path);
      if (codecs.size() > 1 && &codec != &codecs.back()) refuse(path, "its shards are packed as a whole");
    } else if (auto known = codecOf(name); known && hasBytes) {
      array.codecs.push_back(*known);
      addPacking(array, name, settings);
    } else {
      refuseCodec(path, name);
    }
    hasBytes = hasBytes || isToBytes;
  }
  if (!hasBytes) refuse(path, "none of its codecs makes bytes of samples");
  if (array.packing.empty()) array.packing = "raw";
}

}  // namespace velum::io
