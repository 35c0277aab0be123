#include "io/stores/ZarrBricks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "io/read/SampleBytes.h"

namespace velum::io {

namespace {

constexpr std::size_t kMostShards = 32;  ///< that are held open: a slab of them, for threads that go side by side

}  // namespace

ZarrBricks::ZarrBricks(std::shared_ptr<const Store> store, ZarrArray array)
    : mStore(std::move(store)), mArray(std::move(array)) {
  for (std::size_t i = 0; i < mArray.chunk.size(); ++i) mBricksOfShard *= mArray.chunk[i] / mArray.brick[i];
}

std::optional<Bytes> ZarrBricks::read(std::span<const std::uint64_t> index) const {
  if (mArray.shard) return readInShard(index);
  std::string key = chunkKey(mArray, index);
  auto blob = mStore->open(key);
  if (!blob) return std::nullopt;
  return unpack(bytesOf(*blob, mStore->pathOf(key), kMostChunkBytes), key);
}

Bytes ZarrBricks::unpack(Bytes packed, const std::string& key) const {
  return unpackBytes(mArray.codecs, std::move(packed), brickBytes(mArray), mStore->pathOf(key));
}

bool ZarrBricks::has(std::span<const std::uint64_t> index) const {
  return mArray.shard ? find(index).isThere : mStore->open(chunkKey(mArray, index)) != nullptr;
}

ZarrBricks::Place ZarrBricks::find(std::span<const std::uint64_t> index) const {
  std::vector<std::uint64_t> chunk;
  std::size_t brick = 0;
  for (std::size_t i = 0; i < index.size(); ++i) {
    std::uint64_t count = mArray.chunk[i] / mArray.brick[i];
    chunk.push_back(index[i] / count);
    brick = brick * count + index[i] % count;
  }
  Place place;
  place.key = chunkKey(mArray, chunk);
  place.shard = openShard(place.key);
  if (!place.shard->blob) return place;
  constexpr std::uint64_t kNone = ~std::uint64_t(0);
  place.at = place.shard->index[2 * brick], place.size = place.shard->index[2 * brick + 1];
  place.isThere = place.at != kNone || place.size != kNone;
  return place;
}

std::optional<Bytes> ZarrBricks::readInShard(std::span<const std::uint64_t> index) const {
  Place place = find(index);
  if (!place.isThere) return std::nullopt;
  const Blob& blob = *place.shard->blob;
  if (place.at > blob.size() || place.size > blob.size() - place.at || place.size > kMostChunkBytes)
    refuse(mStore->pathOf(place.key), "the index of the shard points beyond its end: it is damaged or cut short");
  Bytes packed(static_cast<std::size_t>(place.size));
  blob.read(place.at, packed);
  return unpack(std::move(packed), place.key);
}

std::shared_ptr<const ZarrBricks::Shard> ZarrBricks::openShard(const std::string& key) const {
  auto take = [&]() -> std::shared_ptr<const Shard> {
    auto found = std::find_if(mShards.begin(), mShards.end(), [&](const auto& shard) { return shard->key == key; });
    if (found == mShards.end()) return nullptr;
    mShards.splice(mShards.begin(), mShards, found);
    return mShards.front();
  };
  {
    std::lock_guard lock(mGuard);
    if (auto shard = take()) return shard;
  }
  auto shard = readShard(key);
  std::lock_guard lock(mGuard);
  if (auto other = take()) return other;
  mShards.push_front(shard);
  if (mShards.size() > kMostShards) mShards.pop_back();
  return shard;
}

std::shared_ptr<const ZarrBricks::Shard> ZarrBricks::readShard(const std::string& key) const {
  auto shard = std::make_shared<Shard>();
  shard->key = key;
  shard->blob = mStore->open(key);
  if (!shard->blob) return shard;
  std::uint64_t indexBytes = 16 * std::uint64_t(mBricksOfShard),
                packedBytes = indexBytes + 4 * mArray.shard->indexCodecs.size();
  Path path = mStore->pathOf(key);
  if (shard->blob->size() < packedBytes) refuse(path, "is too short for the index of a shard");
  Bytes packed(static_cast<std::size_t>(packedBytes));
  shard->blob->read(mArray.shard->isIndexAtStart ? 0 : shard->blob->size() - packedBytes, packed);
  Bytes bytes = unpackBytes(mArray.shard->indexCodecs, std::move(packed), indexBytes, path);
  toMachineOrder(bytes, sizeof(std::uint64_t), mArray.shard->isIndexBigEndian);
  shard->index.resize(2 * mBricksOfShard);
  std::memcpy(shard->index.data(), bytes.data(), bytes.size());
  return shard;
}

}  // namespace velum::io
