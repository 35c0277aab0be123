#include "io/stores/Hdf5Array.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace velum::io {

namespace {

/// Of a dataset in one piece: what is read at once.
constexpr std::uint64_t kPiece = 64;

/// The codec of a filter, by the number that the HDF Group gave it.
std::optional<Codec> codecOf(int filter) {
  switch (filter) {
    case 1:
      return Codec::Inflate;
    case 2:
      return Codec::Shuffle;
    case 32001:
      return Codec::Blosc;
    case 32004:
      return Codec::Lz4Hdf5;
    case 32015:
      return Codec::Zstd;
    default:
      return std::nullopt;
  }
}

std::string nameOf(const Hdf5Filter& filter) {
  switch (filter.id) {
    case 1:
      return "gzip";
    case 2:
      return "shuffle";
    case 32001:
      return "blosc";
    case 32004:
      return "lz4";
    case 32015:
      return "zstd";
    default:
      return filter.name.empty() ? fmt::format("filter {}", filter.id) : inQuotes(filter.name);
  }
}

}  // namespace

Hdf5Array::Hdf5Array(std::unique_ptr<Hdf5Dataset> dataset, const Path& file, const std::string& name)
    : mDataset(std::move(dataset)) {
  path = file / name;
  if (mDataset->shape.size() != 3)
    refuse(path, fmt::format("has {} axes, where an image has z, y and x", mDataset->shape.size()));
  type = mDataset->type;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    size[axis] = mDataset->shape[2 - axis];
    chunk[axis] = mDataset->chunk.empty() ? std::min(size[axis], kPiece) : mDataset->chunk[2 - axis];
  }
  std::vector<std::string> names;
  for (const Hdf5Filter& filter : mDataset->filters) {
    auto codec = codecOf(filter.id);
    mIsOurs = mIsOurs && codec;
    if (codec) mCodecs.push_back(*codec);
    names.push_back(nameOf(filter));
  }
  packing = packingOf(names);
  checkSizes(*this);
}

std::optional<ChunkArray::Chunk> Hdf5Array::read(const FiveSizes& index) const {
  if (mDataset->chunk.empty()) return readByLibrary(index);
  const std::uint64_t place[3] = {index[2], index[1], index[0]};
  auto piece = mDataset->find(place);
  if (!piece) return std::nullopt;
  if (!mIsOurs) return readByLibrary(index);
  return Chunk{unpack(*piece), chunk};
}

Bytes Hdf5Array::unpack(const Hdf5Piece& piece) const {
  std::uint64_t end = piece.file->size();
  if (piece.at > end || piece.size > end - piece.at || piece.size > kMostChunkBytes)
    refuse(path, "a chunk lies beyond the file's end: the file is damaged or cut short");
  Bytes packed(static_cast<std::size_t>(piece.size));
  piece.file->read(piece.at, packed);
  std::vector<Codec> codecs;
  for (std::size_t i = 0; i < mCodecs.size(); ++i)
    if (i >= 32 || !(piece.skipped >> i & 1)) codecs.push_back(mCodecs[i]);
  std::uint64_t bytes = std::accumulate(chunk.begin(), chunk.end(), std::uint64_t(type.bytes), std::multiplies<>());
  return unpackBytes(codecs, std::move(packed), bytes, path, std::size_t(type.bytes));
}

ChunkArray::Chunk Hdf5Array::readByLibrary(const FiveSizes& index) const {
  std::uint64_t origin[3], count[3];
  Chunk made{{}, {1, 1, 1, 1, 1}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    origin[2 - axis] = index[axis] * chunk[axis];
    made.size[axis] = count[2 - axis] = std::min(chunk[axis], size[axis] - origin[2 - axis]);
  }
  made.bytes = mDataset->read(origin, count);
  return made;
}

std::shared_ptr<Hdf5Array> openArray(const Hdf5File& file, const std::string& name) {
  auto dataset = file.open(name);
  return dataset ? std::make_shared<Hdf5Array>(std::move(dataset), file.path(), name) : nullptr;
}

bool isHdf5(std::string_view head) {
  constexpr std::string_view kWord = "\x89HDF\r\n\x1a\n";
  // What a user may put before is a power of two of bytes.
  for (std::size_t at = 0; at + kWord.size() <= head.size(); at = at == 0 ? 512 : 2 * at)
    if (head.substr(at, kWord.size()) == kWord) return true;
  return false;
}

}  // namespace velum::io
