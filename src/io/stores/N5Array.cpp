#include "io/stores/N5Array.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>

#include "io/stores/ZarrCodecs.h"

namespace velum::io {

namespace {

Path attributesPath(const Store& store, const std::string& key) {
  return store.pathOf(key.empty() ? "attributes.json" : key + "/attributes.json");
}

ChunkType n5Type(const Json& value, const Path& path) {
  using Kind = ChunkType::Kind;
  constexpr struct {
    std::string_view name;
    ChunkType type;
  } kTypes[] = {{"uint8", {Kind::Unsigned, 1, true}},  {"uint16", {Kind::Unsigned, 2, true}},
                {"uint32", {Kind::Unsigned, 4, true}}, {"uint64", {Kind::Unsigned, 8, true}},
                {"int8", {Kind::Signed, 1, true}},     {"int16", {Kind::Signed, 2, true}},
                {"int32", {Kind::Signed, 4, true}},    {"int64", {Kind::Signed, 8, true}},
                {"float32", {Kind::Float, 4, true}},   {"float64", {Kind::Float, 8, true}}};
  std::string name = wordOf(value);
  auto found = std::find_if(std::begin(kTypes), std::end(kTypes), [&](const auto& row) { return row.name == name; });
  if (found == std::end(kTypes)) refuse(path, fmt::format("the type {} of its samples is not known", inQuotes(name)));
  return found->type;
}

/// The codecs of a dataset, by their name. Files of N5 1 call it compressionType.
std::vector<Codec> n5Codecs(const Json& attributes, std::string& packing, const Path& path) {
  constexpr struct {
    std::string_view name;
    Codec codec;
  } kCodecs[] = {{"gzip", Codec::Inflate}, {"bzip2", Codec::Bzip2}, {"xz", Codec::Xz},
                 {"lz4", Codec::Lz4Java},  {"blosc", Codec::Blosc}, {"zstd", Codec::Zstd}};
  const Json& compression = memberOf(attributes, "compression");
  std::string name = wordOf(compression.is_string() ? compression : memberOf(compression, "type"));
  if (name.empty()) name = wordOf(memberOf(attributes, "compressionType"));
  packing = name.empty() ? "raw" : name;
  if (packing == "raw") return {};
  auto found = std::find_if(std::begin(kCodecs), std::end(kCodecs), [&](const auto& row) { return row.name == name; });
  if (found == std::end(kCodecs))
    refuse(path, fmt::format("its blocks are packed by {}, which is not known here; raw, gzip, bzip2, xz, lz4, blosc "
                             "and zstd are",
                             inQuotes(name)));
  return {found->codec};
}

/// The head of a block: numbers with their high bytes first.
class BlockHead {
 public:
  BlockHead(std::span<const std::byte> bytes, const Path& path) : mBytes(bytes), mPath(path) {}
  std::uint64_t take(std::size_t count) {
    if (at + count > mBytes.size()) refuse(mPath, "is too short for the head of a block");
    std::uint64_t value = 0;
    for (std::size_t end = at + count; at < end; ++at) value = value << 8 | std::uint64_t(mBytes[at]);
    return value;
  }
  std::size_t at = 0;

 private:
  std::span<const std::byte> mBytes;
  const Path& mPath;
};

}  // namespace

N5Array::N5Array(std::shared_ptr<const Store> store, std::string key, const Json& attributes)
    : mStore(std::move(store)), mKey(std::move(key)) {
  path = attributesPath(*mStore, mKey);
  auto dims = sizesOf(memberOf(attributes, "dimensions"), path, "its list of dimensions");
  auto block = sizesOf(memberOf(attributes, "blockSize"), path, "its blockSize");
  mAxes = dims.size();
  if (mAxes < 2 || mAxes > size.size())
    refuse(path, fmt::format("it has {} axes, where 2 to {} are read", mAxes, size.size()));
  if (block.size() != mAxes) refuse(path, "its blocks have another number of axes than it has");
  std::copy(dims.begin(), dims.end(), size.begin());
  std::copy(block.begin(), block.end(), chunk.begin());
  type = n5Type(memberOf(attributes, "dataType"), path);
  mCodecs = n5Codecs(attributes, packing, path);
  checkSizes(*this);
}

std::optional<ChunkArray::Chunk> N5Array::read(const FiveSizes& index) const {
  std::string key = mKey;
  for (std::size_t axis = 0; axis < mAxes; ++axis) key += (key.empty() ? "" : "/") + std::to_string(index[axis]);
  auto blob = mStore->open(key);
  if (!blob) return std::nullopt;
  Path file = mStore->pathOf(key);
  Bytes bytes = bytesOf(*blob, file, kMostChunkBytes);
  // Read the head: what kind of block it is, its size along each axis, the number of samples where that differs.
  BlockHead head(bytes, file);
  std::uint64_t mode = head.take(2), axes = head.take(2);
  if (mode > 1 || axes != mAxes) refuse(file, "is no block of samples of its dataset");
  Chunk made{{}, {1, 1, 1, 1, 1}};
  std::uint64_t count = 1;
  for (std::size_t axis = 0; axis < mAxes; ++axis) {
    made.size[axis] = head.take(4);
    if (made.size[axis] < 1 || made.size[axis] > chunk[axis])
      refuse(file, fmt::format("its size of {} is not that of a block, {}", made.size[axis], chunk[axis]));
    count *= made.size[axis];
  }
  if (mode == 1 && head.take(4) != count) refuse(file, "has another number of samples than its size says");
  // Unpack what follows.
  bytes.erase(bytes.begin(), bytes.begin() + std::ptrdiff_t(head.at));
  made.bytes = unpackBytes(mCodecs, std::move(bytes), count * std::uint64_t(type.bytes), file, std::size_t(type.bytes));
  return made;
}

Json n5Attributes(const Store& store, const std::string& key) {
  std::string text = textOf(store, key.empty() ? "attributes.json" : key + "/attributes.json");
  return text.empty() ? Json(nullptr) : parseJson(text, attributesPath(store, key));
}

bool isN5Dataset(const Json& attributes) {
  return memberOf(attributes, "dimensions").is_array() && memberOf(attributes, "blockSize").is_array();
}

std::shared_ptr<const N5Array> openN5(std::shared_ptr<const Store> store, const std::string& key) {
  Json attributes = n5Attributes(*store, key);
  if (!isN5Dataset(attributes)) return nullptr;
  return std::make_shared<N5Array>(std::move(store), key, attributes);
}

}  // namespace velum::io
