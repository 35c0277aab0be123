#include "io/stores/ZarrArray.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

#include "io/read/SampleBytes.h"
#include "io/stores/ZarrCodecs.h"

namespace velum::io {

namespace {

using Kind = ChunkType::Kind;

[[noreturn]] void refuseType(const Path& path, const Json& type) {
  std::string name = type.is_string() ? wordOf(type) : type.is_null() ? "nothing" : extensionName(type);
  refuse(path, fmt::format("samples of the type {} cannot be read; whole numbers, floats of 16 to 64 bits and bool can",
                           inQuotes(name.empty() ? "(several fields)" : name)));
}

/// "<u2"
ChunkType typeOfVersion2(const Json& value, const Path& path) {
  std::string text = wordOf(value);
  constexpr std::string_view kKinds = "buif";
  bool isFit = text.size() == 3 && std::string_view("<>|=").find(text[0]) != std::string_view::npos;
  std::size_t kind = isFit ? kKinds.find(text[1]) : kKinds.npos;
  int bytes = isFit ? text[2] - '0' : 0;
  if (kind == kKinds.npos) refuseType(path, value);
  ChunkType type{Kind(kind), bytes, text[0] == '>'};
  bool isSize = type.kind == Kind::Bool    ? bytes == 1
                : type.kind == Kind::Float ? bytes == 2 || bytes == 4 || bytes == 8
                                           : bytes == 1 || bytes == 2 || bytes == 4 || bytes == 8;
  if (!isSize) refuseType(path, value);
  return type;
}

ChunkType typeOfVersion3(const Json& value, const Path& path) {
  constexpr ChunkType kTypes[] = {{Kind::Bool, 1},     {Kind::Unsigned, 1}, {Kind::Unsigned, 2}, {Kind::Unsigned, 4},
                                   {Kind::Unsigned, 8}, {Kind::Signed, 1},   {Kind::Signed, 2},   {Kind::Signed, 4},
                                   {Kind::Signed, 8},   {Kind::Float, 2},    {Kind::Float, 4},    {Kind::Float, 8}};
  for (ChunkType type : kTypes)
    if (extensionName(value) == nameOf(type)) return type;
  refuseType(path, value);
}

/// A half float of the same value, or the nearest in size that it can hold.
std::uint16_t halfOf(float value) {
  auto bits = std::bit_cast<std::uint32_t>(value);
  std::uint32_t sign = (bits >> 16) & 0x8000u, mantissa = bits & 0x7fffffu;
  int exponent = int((bits >> 23) & 255u) - 112;
  if (((bits >> 23) & 255u) == 255) return std::uint16_t(sign | 0x7c00u | (mantissa ? 0x200u : 0u));
  if (exponent >= 31) return std::uint16_t(sign | 0x7c00u);
  if (exponent <= 0) return std::uint16_t(sign | std::uint32_t(std::lround(std::abs(value) * 0x1p24f)));
  return std::uint16_t(sign | (std::uint32_t(exponent) << 10) | (mantissa >> 13));
}

template <class Number>
void put(std::array<std::byte, 8>& fill, Number number) {
  std::memcpy(fill.data(), &number, sizeof(Number));
}

void putFloat(ZarrArray& array, double value) {
  if (array.type.bytes == 2) put(array.fill, halfOf(float(value)));
  if (array.type.bytes == 4) put(array.fill, float(value));
  if (array.type.bytes == 8) put(array.fill, value);
}

/// "NaN", "Infinity", or the bits of the number: "0x7fc00000".
bool putFloatWord(ZarrArray& array, std::string_view word) {
  double infinity = std::numeric_limits<double>::infinity();
  if (word == "NaN") return putFloat(array, std::numeric_limits<double>::quiet_NaN()), true;
  if (word == "Infinity") return putFloat(array, infinity), true;
  if (word == "-Infinity") return putFloat(array, -infinity), true;
  std::uint64_t bits = 0;
  if (!word.starts_with("0x")) return false;
  auto [end, error] = std::from_chars(word.data() + 2, word.data() + word.size(), bits, 16);
  put(array.fill, bits);
  return error == std::errc() && end == word.data() + word.size();
}

void readFill(ZarrArray& array, const Json& value, const Path& path) {
  bool isFit = true;
  if (value.is_string()) {
    isFit = array.type.kind == Kind::Float && putFloatWord(array, wordOf(value));
  } else if (array.type.kind == Kind::Float && value.is_number()) {
    putFloat(array, value.get<double>());
  } else if (value.is_boolean()) {
    put(array.fill, std::uint64_t(value.get<bool>()));
  } else if (value.is_number_integer()) {
    put(array.fill, value.get<std::uint64_t>());  // the low bytes of a negative number, too
  } else if (value.is_number()) {
    isFit = std::abs(value.get<double>()) < 9e15 && std::floor(value.get<double>()) == value.get<double>();
    if (isFit) put(array.fill, std::int64_t(value.get<double>()));
  } else {
    isFit = value.is_null();
  }
  if (!isFit) refuse(path, "its fill_value is no sample of its type");
  toMachineOrder(std::span(array.fill).first(std::size_t(array.type.bytes)), std::size_t(array.type.bytes),
                 array.type.isBigEndian);
}

char separatorOf(const Json& value, char otherwise, const Path& path) {
  if (value.is_null()) return otherwise;
  std::string text = wordOf(value);
  if (text != "/" && text != ".") refuse(path, "the separator in its chunks' keys is neither / nor .");
  return text[0];
}

void checkSizes(const ZarrArray& array, const Path& path) {
  if (array.shape.empty()) refuse(path, "it is a single number and no array");
  if (array.chunk.size() != array.shape.size()) refuse(path, "its chunks have another number of axes than it has");
  auto check = [&](const std::vector<std::uint64_t>& sizes, std::uint64_t bytes, std::uint64_t most) {
    for (std::uint64_t size : sizes) {
      if (size > most / bytes)
        refuse(path, fmt::format("its chunks of {} samples are larger than 2 GiB", fmt::join(sizes, " x ")));
      bytes *= size;
    }
  };
  check(array.brick, std::uint64_t(array.type.bytes), kMostChunkBytes);
  if (!array.shard) return;
  // The index has 16 bytes a brick.
  std::vector<std::uint64_t> bricks;
  for (std::size_t i = 0; i < array.chunk.size(); ++i) bricks.push_back(array.chunk[i] / array.brick[i]);
  check(bricks, 16, std::uint64_t(64) << 20);
}

void readVersion2(ZarrArray& array, const Json& metadata, const Path& path) {
  array.chunk = sizesOf(memberOf(metadata, "chunks"), path, "its list of chunks");
  array.brick = array.chunk;
  array.type = typeOfVersion2(memberOf(metadata, "dtype"), path);
  array.isFlatKey = true;
  array.separator = separatorOf(memberOf(metadata, "dimension_separator"), '.', path);
  std::string order = wordOf(memberOf(metadata, "order"));
  if (order != "C" && order != "F") refuse(path, "the order of its samples is neither C nor F");
  if (order == "F") std::reverse(array.order.begin(), array.order.end());
  readCompressor(array, metadata, path);
}

/// Members of the metadata that nobody here knows may be passed over only where they say so.
void checkMembers(const Json& metadata, const Path& path) {
  constexpr std::string_view kKnown[] = {"zarr_format",
                                         "node_type",
                                         "shape",
                                         "data_type",
                                         "chunk_grid",
                                         "fill_value",
                                         "codecs",
                                         "chunk_key_encoding",
                                         "attributes",
                                         "dimension_names",
                                         "storage_transformers",
                                         "consolidated_metadata"};
  for (const auto& [name, value] : metadata.items()) {
    if (std::find(std::begin(kKnown), std::end(kKnown), name) != std::end(kKnown)) continue;
    if (memberOf(value, "must_understand") != false)
      refuse(path, fmt::format("its metadata has {}, which is not known here", inQuotes(name)));
  }
  const Json& transformers = memberOf(metadata, "storage_transformers");
  if (transformers.is_array() && !transformers.empty())
    refuse(path, fmt::format("the storage transformer {} is not known here", inQuotes(extensionName(transformers[0]))));
}

void readVersion3(ZarrArray& array, const Json& metadata, const Path& path) {
  checkMembers(metadata, path);
  const Json& grid = memberOf(metadata, "chunk_grid");
  if (extensionName(grid) != "regular")
    refuse(path, fmt::format("its grid of chunks, {}, is not known here", inQuotes(extensionName(grid))));
  array.chunk = sizesOf(memberOf(memberOf(grid, "configuration"), "chunk_shape"), path, "its chunk_shape");
  array.brick = array.chunk;
  array.type = typeOfVersion3(memberOf(metadata, "data_type"), path);
  const Json& encoding = memberOf(metadata, "chunk_key_encoding");
  std::string name = extensionName(encoding);
  if (name != "default" && name != "v2")
    refuse(path, fmt::format("the way {} of naming chunks is not known here", inQuotes(name)));
  array.isFlatKey = name == "v2";
  array.separator =
      separatorOf(memberOf(memberOf(encoding, "configuration"), "separator"), array.isFlatKey ? '.' : '/', path);
  const Json& names = memberOf(metadata, "dimension_names");
  if (names.is_array() && names.size() == array.shape.size())
    for (const Json& axis : names) array.axes.push_back(wordOf(axis));
  readCodecs(array, memberOf(metadata, "codecs"), path);
}

}  // namespace

std::optional<ZarrArray> readZarrArray(const Store& store, const std::string& key) {
  std::string file = keyBelow(store, key, "zarr.json"), text = textOf(store, file);
  bool isVersion3 = !text.empty();
  if (!isVersion3) {
    file = keyBelow(store, key, ".zarray");
    text = textOf(store, file);
  }
  if (text.empty()) return std::nullopt;
  Path path = store.pathOf(file);
  Json metadata = parseJson(text, path);
  if (isVersion3 && memberOf(metadata, "node_type") != "array") return std::nullopt;
  if (memberOf(metadata, "zarr_format") != (isVersion3 ? 3 : 2)) refuse(path, "is no metadata of Zarr version 2 or 3");
  ZarrArray array;
  array.key = key;
  array.shape = sizesOf(memberOf(metadata, "shape"), path, "its shape");
  array.order.resize(array.shape.size());
  std::iota(array.order.begin(), array.order.end(), std::size_t(0));
  isVersion3 ? readVersion3(array, metadata, path) : readVersion2(array, metadata, path);
  checkSizes(array, path);
  readFill(array, memberOf(metadata, "fill_value"), path);
  return array;
}

std::uint64_t brickBytes(const ZarrArray& array) {
  return std::accumulate(array.brick.begin(), array.brick.end(), std::uint64_t(array.type.bytes), std::multiplies<>());
}

std::string chunkKey(const ZarrArray& array, std::span<const std::uint64_t> index) {
  std::string key = array.isFlatKey ? "" : "c";
  for (std::uint64_t number : index) {
    if (!key.empty()) key += array.separator;
    key += std::to_string(number);
  }
  return array.key.empty() ? key : array.key + "/" + key;
}

}  // namespace velum::io
