#include "io/stores/StoreWriter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/Parallel.h"
#include "core/ReplaceFile.h"
#include "io/stores/ReduceBlocks.h"
#include "io/stores/ShardFile.h"

namespace velum::io {

namespace {

constexpr int kShardedEdge = 64;  ///< of a brick: what others read at once
constexpr int kFileEdge = 128;    ///< of a brick that is a file of its own

glm::ivec3 divideUp(glm::ivec3 a, glm::ivec3 b) { return (a + b - 1) / b; }
std::size_t volumeOf(glm::ivec3 size) { return std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z); }

glm::ivec3 placeOf(std::size_t number, glm::ivec3 grid) {
  auto x = std::size_t(grid.x), y = std::size_t(grid.y);
  return {int(number % x), int(number / x % y), int(number / x / y)};
}

/// The samples at the beginning of a larger brick, the rest 0.
Bytes padded(const Bytes& samples, glm::ivec3 size, glm::ivec3 brick, std::size_t sampleBytes) {
  Bytes whole(volumeOf(brick) * sampleBytes);
  std::fill(whole.begin(), whole.end(), std::byte(0));
  std::size_t row = std::size_t(size.x) * sampleBytes, wholeRow = std::size_t(brick.x) * sampleBytes;
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y)
      std::memcpy(whole.data() + (std::size_t(z) * std::size_t(brick.y) + std::size_t(y)) * wholeRow,
                  samples.data() + (std::size_t(z) * std::size_t(size.y) + std::size_t(y)) * row, row);
  return whole;
}

bool isAllZero(const Bytes& bytes) {
  return bytes.empty() ||
         (bytes.front() == std::byte(0) && std::memcmp(bytes.data(), bytes.data() + 1, bytes.size() - 1) == 0);
}

}  // namespace

StoreWriter::StoreWriter(const VoxelSource& source, Volume head, Path folder, const StoreOptions& options,
                         Progress& progress)
    : mSource(source), mHead(std::move(head)), mFolder(std::move(folder)), mOptions(options), mProgress(progress) {
  mLayout.version = options.version;
  mLayout.zstdLevel = options.zstdLevel;
  mLayout.isLabels = options.isLabels;
  mLayout.carriesIds = options.carriesIds;
  int edge = options.version == OmeVersion::V04 ? kFileEdge : kShardedEdge;
  mLayout.levels = planPyramid(mHead.dims, spacingOf(mHead), edge, sampleSize(mHead.type));
  for (const PlannedLevel& level : mLayout.levels)
    mTotal += double(volumeOf(level.dims)) * mHead.channels * mHead.timeSteps;
}

void StoreWriter::writeLevels() {
  writeFinest();
  mSlab = Bytes();
  for (int level = 1; level < int(mLayout.levels.size()); ++level) writeCoarser(level);
}

/// Slabs are as wide as the memory permits, so that bricks of the source, which lie otherwise, are read once if
/// possible; as deep as a shard, and of all channels and time steps that a brick of the source holds together.
void StoreWriter::writeFinest() {
  const PlannedLevel& level = mLayout.levels.front();
  const VoxelLevel& from = mSource.levels()[std::size_t(mOptions.level)];
  BrickBox slab;
  slab.size = glm::min(level.shard, level.dims);
  slab.channels = from.brickChannels;
  slab.timeSteps = from.brickTimeSteps;
  if (bytesOf(slab, mHead.type) > mOptions.slabBytes) slab.channels = slab.timeSteps = 1;
  for (int axis : {0, 1})
    while (slab.size[axis] < level.dims[axis]) {
      BrickBox wider = slab;
      wider.size[axis] = std::min(level.dims[axis], slab.size[axis] + level.shard[axis]);
      if (bytesOf(wider, mHead.type) > mOptions.slabBytes) break;
      slab = wider;
    }
  glm::ivec3 slabs = divideUp(level.dims, slab.size);
  for (int t = 0; t < mHead.timeSteps; t += slab.timeSteps)
    for (int c = 0; c < mHead.channels; c += slab.channels)
      for (std::size_t i = 0; i < volumeOf(slabs); ++i) {
        BrickBox one = slab;
        one.origin = placeOf(i, slabs) * slab.size;
        one.size = glm::min(slab.size, level.dims - one.origin);
        one.channel = c;
        one.channels = std::min(slab.channels, mHead.channels - c);
        one.timeStep = t;
        one.timeSteps = std::min(slab.timeSteps, mHead.timeSteps - t);
        writeSlab(one);
      }
}

void StoreWriter::writeSlab(BrickBox slab) {
  const PlannedLevel& level = mLayout.levels.front();
  // Which of its shards are missing?
  std::vector<Place> missing;
  glm::ivec3 shards = divideUp(slab.size, level.shard);
  for (int t = 0; t < slab.timeSteps; ++t)
    for (int c = 0; c < slab.channels; ++c)
      for (std::size_t i = 0; i < volumeOf(shards); ++i) {
        Place place{slab.timeStep + t, slab.channel + c, slab.origin / level.shard + placeOf(i, shards)};
        if (isThere(0, place))
          tellShard(0, glm::min(level.shard, level.dims - place.shard * level.shard));
        else
          missing.push_back(place);
      }
  if (missing.empty()) return;
  // Read the slab, and write them out of it.
  readBoxInto(mSlab, mSource, mOptions.level, slab, mProgress);
  SampleTarget all = targetIn(mSlab.data(), slab, mHead.type);
  auto cut = [&](const BrickBox& box, Bytes& brick) {
    brick.resize(bytesOf(box, mHead.type));
    glm::ivec3 at = box.origin - slab.origin;
    const std::byte* first = all.first + (box.timeStep - slab.timeStep) * all.timeStep +
                             (box.channel - slab.channel) * all.channel + at.z * all.z + at.y * all.y + at.x * all.x;
    std::size_t row = std::size_t(box.size.x) * sampleSize(mHead.type);
    std::byte* to = brick.data();
    for (int z = 0; z < box.size.z; ++z)
      for (int y = 0; y < box.size.y; ++y, to += row) std::memcpy(to, first + z * all.z + y * all.y, row);
  };
  parallelFor(std::size_t(0), missing.size(), [&](std::size_t i) { writeShard(0, missing[i], cut); });
}

ZarrSource StoreWriter::written(int level) const {
  OmeImage image;
  image.axes = axesOf(mHead);
  image.isBare = true;
  OmeLevel one;
  one.key = std::to_string(level);
  one.scale.assign(image.axes.size(), 1.0);
  one.translation.assign(image.axes.size(), 0.0);
  image.levels = {one};
  return {std::shared_ptr<const Store>(openStore(mFolder)), image, {}};
}

void StoreWriter::reduceInto(Bytes& samples, const VoxelSource& finer, const PlannedLevel& level,
                             const BrickBox& box) const {
  BrickBox from = box;
  from.origin = box.origin * level.factor;
  from.size = glm::min(box.size * level.factor, finer.levels().front().dims - from.origin);
  thread_local Bytes finerSamples;
  // While this thread waits it must not begin another brick, which would use the same bytes.
  isolated([&] { readBoxInto(finerSamples, finer, 0, from, mProgress); });
  samples.resize(bytesOf(box, mHead.type));
  reduceBlocks(mHead.type, mLayout.isLabels ? Reduction::Majority : Reduction::Mean, finerSamples.data(), from.size,
               box.size, level.factor, samples.data());
}

void StoreWriter::writeCoarser(int number) {
  const PlannedLevel& level = mLayout.levels[std::size_t(number)];
  ZarrSource finer = written(number - 1);
  if (mLayout.carriesIds) finer.carryIds();
  glm::ivec3 shards = divideUp(level.dims, level.shard);
  std::size_t ofChannel = volumeOf(shards), channels = std::size_t(mHead.channels);
  auto fill = [&](const BrickBox& box, Bytes& samples) { reduceInto(samples, finer, level, box); };
  parallelFor(std::size_t(0), ofChannel * channels * std::size_t(mHead.timeSteps), [&](std::size_t i) {
    Place place{int(i / ofChannel / channels), int(i / ofChannel % channels), placeOf(i % ofChannel, shards)};
    if (isThere(number, place))
      tellShard(number, glm::min(level.shard, level.dims - place.shard * level.shard));
    else
      writeShard(number, place, fill);
  });
}

void StoreWriter::writeShard(int number, const Place& place, const Fill& fill) {
  const PlannedLevel& level = mLayout.levels[std::size_t(number)];
  glm::ivec3 grid = level.shard / level.brick, first = place.shard * level.shard;
  std::vector<Bytes> bricks(volumeOf(grid));
  // Only on bricks of this shard: a thread that waits must not begin another one, which would be held in memory, too.
  isolated([&] {
    parallelFor(std::size_t(0), bricks.size(), [&](std::size_t i) {
      mProgress.throwIfCancelled();
      BrickBox box;
      box.origin = first + placeOf(i, grid) * level.brick;
      if (glm::any(glm::greaterThanEqual(box.origin, level.dims))) return;
      box.size = glm::min(level.brick, level.dims - box.origin);
      box.channel = place.channel;
      box.timeStep = place.timeStep;
      bricks[i] = packedBrick(number, box, fill);
      if (mLayout.version == OmeVersion::V04 && !bricks[i].empty()) writeFile(brickPath(number, place, i), bricks[i]);
    });
  });
  bool isEmpty = std::all_of(bricks.begin(), bricks.end(), [](const Bytes& brick) { return brick.empty(); });
  if (mLayout.version == OmeVersion::V05 && !isEmpty) {
    Path path = shardPath(number, place);
    makeFolders(path.parent_path());
    ReplaceFile file(path);
    writeShardFile(bricks, file);
    file.commit();
  }
  tellShard(number, glm::min(level.shard, level.dims - first));
}

Bytes StoreWriter::packedBrick(int number, const BrickBox& box, const Fill& fill) const {
  thread_local Bytes samples;
  fill(box, samples);
  if (isAllZero(samples)) return {};
  glm::ivec3 brick = mLayout.levels[std::size_t(number)].brick;
  if (box.size == brick) return packZstd(samples, mOptions.zstdLevel);
  return packZstd(padded(samples, box.size, brick, sampleSize(mHead.type)), mOptions.zstdLevel);
}

bool StoreWriter::isThere(int number, const Place& place) const {
  if (!mResumes) return false;
  const PlannedLevel& level = mLayout.levels[std::size_t(number)];
  glm::ivec3 grid = level.shard / level.brick;
  if (mLayout.version == OmeVersion::V05) return isWholeShard(shardPath(number, place), volumeOf(grid));
  for (std::size_t i = 0; i < volumeOf(grid); ++i) {
    bool isInside = glm::all(glm::lessThan(place.shard * level.shard + placeOf(i, grid) * level.brick, level.dims));
    if (isInside && !std::filesystem::exists(brickPath(number, place, i))) return false;
  }
  return true;
}

Path StoreWriter::chunkPath(int level, int timeStep, int channel, glm::ivec3 index) const {
  Path path = mFolder / std::to_string(level);
  if (mLayout.version == OmeVersion::V05) path /= "c";
  for (int number : alongAxes(axesOf(mHead), timeStep, channel, index)) path /= std::to_string(number);
  return path;
}

Path StoreWriter::shardPath(int level, const Place& place) const {
  return chunkPath(level, place.timeStep, place.channel, place.shard);
}

Path StoreWriter::brickPath(int number, const Place& place, std::size_t brick) const {
  const PlannedLevel& level = mLayout.levels[std::size_t(number)];
  glm::ivec3 grid = level.shard / level.brick;
  return chunkPath(number, place.timeStep, place.channel, place.shard * grid + placeOf(brick, grid));
}

void StoreWriter::writeFile(const Path& path, std::span<const std::byte> bytes) const {
  makeFolders(path.parent_path());
  ReplaceFile file(path);
  file.write(bytes);
  file.commit();
}

void StoreWriter::tellShard(int level, glm::ivec3 voxels) {
  std::lock_guard lock(mTelling);
  mDone += double(volumeOf(voxels));
  mProgress.report(mDone / mTotal, fmt::format("Writing level {} of 0 to {}", level, mLayout.levels.size() - 1));
}

}  // namespace velum::io
