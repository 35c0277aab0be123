#pragma once
#include <blosc.h>
#include <lz4.h>
#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <glm/gtc/packing.hpp>
#include <nlohmann/json.hpp>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "io/stores/Crc32c.h"

/// Writes Zarr as the specification says, in the plainest way: what the readers are held against.
namespace velum::io {

using Json = nlohmann::json;
using Sizes = std::vector<std::uint64_t>;

inline void writeBytes(const std::filesystem::path& path, const std::string& bytes) {
  std::filesystem::remove(path);
  std::ofstream(path, std::ios::binary) << bytes;
}

template <class Number>
std::string bytesOfNumber(Number number, bool isBigEndian = false) {
  std::string bytes(reinterpret_cast<const char*>(&number), sizeof(Number));
  if (isBigEndian) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

/// A sample of the type that Zarr calls so.
inline std::string sampleBytes(const std::string& type, double value, bool isBigEndian) {
  if (type == "bool") return bytesOfNumber(std::uint8_t(value != 0));
  if (type == "uint8") return bytesOfNumber(std::uint8_t(value));
  if (type == "int8") return bytesOfNumber(std::int8_t(value));
  if (type == "uint16") return bytesOfNumber(std::uint16_t(value), isBigEndian);
  if (type == "int16") return bytesOfNumber(std::int16_t(value), isBigEndian);
  if (type == "uint32") return bytesOfNumber(std::uint32_t(value), isBigEndian);
  if (type == "int32") return bytesOfNumber(std::int32_t(value), isBigEndian);
  if (type == "uint64") return bytesOfNumber(std::uint64_t(value), isBigEndian);
  if (type == "int64") return bytesOfNumber(std::int64_t(value), isBigEndian);
  if (type == "float32") return bytesOfNumber(float(value), isBigEndian);
  if (type == "float64") return bytesOfNumber(value, isBigEndian);
  return bytesOfNumber(std::uint16_t(glm::packHalf1x16(float(value))), isBigEndian);
}

/// "<u2" for "uint16"
inline std::string typeOfVersion2(const std::string& type, bool isBigEndian) {
  if (type == "bool") return "|b1";
  std::size_t digits = type.find_first_of("0123456789");
  int bytes = std::stoi(type.substr(digits)) / 8;
  char kind = type[0] == 'u' ? 'u' : type[0] == 'i' ? 'i' : 'f';
  return std::string(1, bytes == 1 ? '|' : isBigEndian ? '>' : '<') + kind + std::to_string(bytes);
}

inline std::string packedBy(const std::string& codec, const std::string& bytes, int sampleSize) {
  if (codec == "gzip" || codec == "zlib") {
    z_stream stream{};
    ::deflateInit2(&stream, 6, Z_DEFLATED, codec == "gzip" ? MAX_WBITS + 16 : MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
    std::string packed(::deflateBound(&stream, uLong(bytes.size())) + 64, '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = uInt(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = uInt(packed.size());
    ::deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    ::deflateEnd(&stream);
    return packed;
  }
  if (codec == "zstd") {
    std::string packed(::ZSTD_compressBound(bytes.size()), '\0');
    packed.resize(::ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), 3));
    return packed;
  }
  if (codec == "lz4") {
    std::string packed(std::size_t(::LZ4_compressBound(int(bytes.size()))), '\0');
    packed.resize(
        std::size_t(::LZ4_compress_default(bytes.data(), packed.data(), int(bytes.size()), int(packed.size()))));
    return bytesOfNumber(std::uint32_t(bytes.size())) + packed;
  }
  if (codec == "blosc") {
    std::string packed(bytes.size() + BLOSC_MAX_OVERHEAD, '\0');
    packed.resize(std::size_t(::blosc_compress_ctx(5, BLOSC_BITSHUFFLE, std::size_t(sampleSize), bytes.size(),
                                                   bytes.data(), packed.data(), packed.size(), "lz4", 0, 1)));
    return packed;
  }
  return bytes;
}

/// An array that is to be written.
struct ZarrFile {
  std::filesystem::path folder;
  int version = 3;
  Sizes shape, chunk, shard;  ///< no shard: chunks have keys of their own
  std::string type = "uint16", codec = "raw";
  bool isBigEndian = false, hasCrc = false, isIndexAtStart = false;
  bool isOrderF = false;               ///< of version 2
  std::vector<std::size_t> transpose;  ///< of version 3; empty: none
  Json fill = 0;
  std::function<double(const Sizes&)> value;                               ///< of a sample, by its index
  std::function<bool(const Sizes&)> isThere = [](auto&) { return true; };  ///< a chunk, by its index

  void write() const;
  std::string brick(const Sizes& index) const;
  std::string shardOf(const Sizes& index) const;
  Json metadata() const;
  Json codecs() const;
};

/// Calls body with each index below the sizes, the last axis fastest.
inline void forEach(const Sizes& sizes, const std::function<void(const Sizes&)>& body) {
  Sizes index(sizes.size(), 0);
  for (;;) {
    body(index);
    std::size_t axis = sizes.size();
    while (axis > 0 && ++index[axis - 1] == sizes[axis - 1]) index[--axis] = 0;
    if (axis == 0) return;
  }
}

inline Sizes divided(const Sizes& a, const Sizes& b) {
  Sizes out;
  for (std::size_t i = 0; i < a.size(); ++i) out.push_back((a[i] + b[i] - 1) / b[i]);
  return out;
}

inline std::string ZarrFile::brick(const Sizes& index) const {
  std::vector<std::size_t> order(shape.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  if (isOrderF) std::reverse(order.begin(), order.end());
  if (!transpose.empty()) order = transpose;
  Sizes sizes;
  for (std::size_t axis : order) sizes.push_back(chunk[axis]);
  std::string bytes;
  forEach(sizes, [&](const Sizes& at) {
    Sizes sample(shape.size());
    bool isInside = true;
    for (std::size_t i = 0; i < order.size(); ++i) sample[order[i]] = index[order[i]] * chunk[order[i]] + at[i];
    for (std::size_t i = 0; i < shape.size(); ++i) isInside = isInside && sample[i] < shape[i];
    bytes += sampleBytes(type, isInside ? value(sample) : 77, isBigEndian);
  });
  std::string packed = packedBy(codec, bytes, int(sampleBytes(type, 0, false).size()));
  if (hasCrc) packed += bytesOfNumber(crc32cByTable(std::as_bytes(std::span(packed))));
  return packed;
}

inline std::string ZarrFile::shardOf(const Sizes& index) const {
  Sizes count = divided(shard, chunk);
  std::string bytes, table;
  std::size_t bricks = std::accumulate(count.begin(), count.end(), std::size_t(1), std::multiplies<>());
  std::size_t start = isIndexAtStart ? 16 * bricks + 4 : 0;
  forEach(count, [&](const Sizes& at) {
    Sizes brickIndex;
    for (std::size_t i = 0; i < at.size(); ++i) brickIndex.push_back(index[i] * count[i] + at[i]);
    if (!isThere(brickIndex)) {
      table += std::string(16, '\xff');
      return;
    }
    std::string packed = brick(brickIndex);
    table += bytesOfNumber(std::uint64_t(start + bytes.size())) + bytesOfNumber(std::uint64_t(packed.size()));
    bytes += packed + "gap";
  });
  table += bytesOfNumber(crc32cByTable(std::as_bytes(std::span(table))));
  return isIndexAtStart ? table + bytes : bytes + table;
}

inline Json ZarrFile::codecs() const {
  Json list = Json::array();
  if (!transpose.empty()) list.push_back({{"name", "transpose"}, {"configuration", {{"order", transpose}}}});
  list.push_back({{"name", "bytes"}, {"configuration", {{"endian", isBigEndian ? "big" : "little"}}}});
  if (codec != "raw") list.push_back({{"name", codec}, {"configuration", Json::object()}});
  if (hasCrc) list.push_back({{"name", "crc32c"}});
  if (shard.empty()) return list;
  Json index = {{{"name", "bytes"}, {"configuration", {{"endian", "little"}}}}, {{"name", "crc32c"}}};
  return {{{"name", "sharding_indexed"},
           {"configuration",
            {{"chunk_shape", chunk},
             {"codecs", list},
             {"index_codecs", index},
             {"index_location", isIndexAtStart ? "start" : "end"}}}}};
}

inline Json ZarrFile::metadata() const {
  if (version == 2)
    return {{"zarr_format", 2},
            {"shape", shape},
            {"chunks", chunk},
            {"dtype", typeOfVersion2(type, isBigEndian)},
            {"compressor", codec == "raw" ? Json(nullptr) : Json{{"id", codec}}},
            {"fill_value", fill},
            {"order", isOrderF ? "F" : "C"},
            {"filters", nullptr},
            {"dimension_separator", "/"}};
  return {{"zarr_format", 3},
          {"node_type", "array"},
          {"shape", shape},
          {"data_type", type},
          {"chunk_grid", {{"name", "regular"}, {"configuration", {{"chunk_shape", shard.empty() ? chunk : shard}}}}},
          {"chunk_key_encoding", {{"name", "default"}, {"configuration", {{"separator", "/"}}}}},
          {"fill_value", fill},
          {"codecs", codecs()},
          {"attributes", Json::object()}};
}

inline void ZarrFile::write() const {
  std::filesystem::create_directories(folder);
  writeBytes(folder / (version == 2 ? ".zarray" : "zarr.json"), metadata().dump());
  forEach(divided(shape, shard.empty() ? chunk : shard), [&](const Sizes& index) {
    if (shard.empty() && !isThere(index)) return;
    std::filesystem::path path = version == 2 ? folder : folder / "c";
    for (std::uint64_t number : index) path /= std::to_string(number);
    std::filesystem::create_directories(path.parent_path());
    writeBytes(path, shard.empty() ? brick(index) : shardOf(index));
  });
}

/// The attributes of an image, as text of `.zattrs` (0.4) or `zarr.json` (0.5). @param more  members beside multiscales
inline void writeGroup(const std::filesystem::path& folder, int zarrVersion, Json ome) {
  std::filesystem::create_directories(folder);
  if (zarrVersion == 2) {
    writeBytes(folder / ".zgroup", R"({"zarr_format": 2})");
    writeBytes(folder / ".zattrs", ome.dump());
    return;
  }
  ome["version"] = "0.5";
  writeBytes(folder / "zarr.json",
             Json{{"zarr_format", 3}, {"node_type", "group"}, {"attributes", {{"ome", ome}}}}.dump());
}

/// "tczyx" as the axes of an image, whose lengths are in micrometres and times in seconds.
inline Json axesOf(const std::string& names) {
  Json axes = Json::array();
  for (char name : names) {
    Json axis = {{"name", std::string(1, name)}, {"type", name == 't' ? "time" : name == 'c' ? "channel" : "space"}};
    if (name == 't') axis["unit"] = "second";
    if (name != 't' && name != 'c') axis["unit"] = "micrometer";
    axes.push_back(axis);
  }
  return axes;
}

/// A level at `path`. @param translation  empty: none
inline Json levelAt(const std::string& path, const std::vector<double>& scale,
                    const std::vector<double>& translation = {}) {
  Json transformations = {{{"type", "scale"}, {"scale", scale}}};
  if (!translation.empty()) transformations.push_back({{"type", "translation"}, {"translation", translation}});
  return {{"path", path}, {"coordinateTransformations", transformations}};
}

}  // namespace velum::io
