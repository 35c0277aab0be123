#include "io/volumes/TiffSource.h"

#include <algorithm>

#include "io/read/SampleBytes.h"
#include "io/volumes/RawSource.h"

namespace velum::io {

namespace {

int divideUp(int count, int size) { return (count + size - 1) / size; }

}  // namespace

TiffSource::TiffSource(std::shared_ptr<const FileBytes> file, Volume head, int samples, bool isPlanar, bool isBigEndian)
    : mFile(std::move(file)),
      mHead(std::move(head)),
      mSamples(samples),
      mIsPlanar(isPlanar),
      mIsBigEndian(isBigEndian) {}

std::size_t TiffSource::pixelBytes() const { return sampleSize(mHead.type) * (mIsPlanar ? 1 : std::size_t(mSamples)); }

void TiffSource::addLevel(Stored stored, glm::ivec2 dims, glm::dvec2 factor) {
  VoxelLevel level;
  level.dims = {dims, mHead.dims.z};
  level.brickChannels = mIsPlanar ? 1 : mSamples;
  int unit = stored.plain.empty() ? stored.chunk.y : 1;
  level.brickSize = {stored.chunk, 1};
  if (!stored.isTiled) level.brickSize = {dims.x, rowsOfBrick(level.dims, unit, pixelBytes()), 1};
  if (stored.isTiled || level.brickSize.y == dims.y)
    level.brickSize.z =
        planesOfBrick(level.dims.z, std::size_t(level.brickSize.x) * std::size_t(level.brickSize.y) * pixelBytes());
  // The centre of a voxel carries its place: the first voxel of a mean of blocks lies in the middle of the first block.
  glm::dvec3 scale(factor, 1.0), first = (scale - 1.0) / 2.0;
  level.worldFromVoxel = mHead.worldFromVoxel;
  level.worldFromVoxel[3] = mHead.worldFromVoxel * glm::dvec4(first, 1.0);
  for (int axis = 0; axis < 3; ++axis) level.worldFromVoxel[axis] *= scale[axis];
  mLevels.push_back(level);
  mStored.push_back(std::move(stored));
}

void TiffSource::read(const BrickAddress& address, const SampleTarget& target) const {
  BrickBox box = boxOf(*this, address);
  const Stored& stored = mStored[std::size_t(address.level)];
  auto planesOf = [&](int channel) { return std::size_t(channel / mSamples); };
  std::size_t first =
      (std::size_t(box.timeStep) * planesOf(mHead.channels) + planesOf(box.channel)) * std::size_t(mHead.dims.z);
  BrickBox one = box;
  one.size.z = 1;
  for (int z = 0; z < box.size.z; ++z) {
    one.origin.z = box.origin.z + z;
    std::size_t plane = first + std::size_t(one.origin.z);
    SampleTarget to = target;
    to.first += z * target.z;
    if (stored.plain.empty())
      readChunks(address.level, plane, mIsPlanar ? box.channel % mSamples : 0, one, to);
    else
      readPlain(stored.plain[plane], one, to);
  }
}

/// Reads rows of a plane that lies in the file as it is.
void TiffSource::readPlain(std::uint64_t plane, const BrickBox& box, const SampleTarget& target) const {
  std::size_t pixel = pixelBytes(), row = std::size_t(box.size.x) * pixel;
  thread_local Bytes samples;
  samples.resize(row * std::size_t(box.size.y));
  mFile->read(plane + std::uint64_t(box.origin.y) * row, samples);
  toMachineOrder(samples, sampleSize(mHead.type), mIsBigEndian);
  SampleTarget from{
      samples.data(), std::ptrdiff_t(pixel), std::ptrdiff_t(row), 0, std::ptrdiff_t(sampleSize(mHead.type)), 0};
  copySamples(box, sampleSize(mHead.type), from, target);
}

/// Unpacks the tiles or strips of a plane that a box lies in.
void TiffSource::readChunks(int level, std::size_t plane, int sample, const BrickBox& box,
                            const SampleTarget& target) const {
  const Stored& stored = mStored[std::size_t(level)];
  glm::ivec2 dims = mLevels[std::size_t(level)].dims, size = stored.chunk;
  int across = divideUp(dims.x, size.x), down = divideUp(dims.y, size.y);
  std::size_t pixel = pixelBytes(), row = std::size_t(size.x) * pixel;
  glm::ivec2 low = box.origin, high = low + glm::ivec2(box.size);
  thread_local Bytes samples;
  auto decoder = takeDecoder();
  for (int y = low.y / size.y; y * size.y < high.y; ++y)
    for (int x = low.x / size.x; x * size.x < high.x; ++x) {
      glm::ivec2 origin = glm::ivec2(x, y) * size;
      int rows = stored.isTiled ? size.y : std::min(size.y, dims.y - origin.y);
      samples.resize(row * std::size_t(rows));
      TiffChunk chunk;
      chunk.directory = stored.directories[plane];
      chunk.number = std::uint32_t((sample * down + y) * across + x);
      chunk.width = std::uint32_t(dims.x);
      chunk.height = std::uint32_t(dims.y);
      chunk.chunkWidth = stored.isTiled ? std::uint32_t(size.x) : 0;
      chunk.chunkHeight = std::uint32_t(size.y);
      chunk.mostExpansion = stored.mostExpansion;
      decoder->read(chunk, samples);
      // Copy what is in the box.
      glm::ivec2 from = glm::max(origin, low), to = glm::min(origin + size, high);
      BrickBox shared = box;
      shared.size = {to - from, 1};
      glm::ivec2 inChunk = from - origin, inBox = from - low;
      SampleTarget source{samples.data() + std::size_t(inChunk.y) * row + std::size_t(inChunk.x) * pixel,
                          std::ptrdiff_t(pixel),
                          std::ptrdiff_t(row),
                          0,
                          std::ptrdiff_t(sampleSize(mHead.type)),
                          0};
      SampleTarget there = target;
      there.first += inBox.x * target.x + inBox.y * target.y;
      copySamples(shared, sampleSize(mHead.type), source, there);
    }
  giveBack(std::move(decoder));
}

std::unique_ptr<TiffDecoder> TiffSource::takeDecoder() const {
  {
    std::lock_guard lock(mGuard);
    if (!mDecoders.empty()) {
      auto decoder = std::move(mDecoders.back());
      mDecoders.pop_back();
      return decoder;
    }
  }
  return openTiffDecoder(mFile);
}

void TiffSource::giveBack(std::unique_ptr<TiffDecoder> decoder) const {
  std::lock_guard lock(mGuard);
  mDecoders.push_back(std::move(decoder));
}

std::string TiffSource::identity() const { return stampOf(mFile->path()); }

}  // namespace velum::io
