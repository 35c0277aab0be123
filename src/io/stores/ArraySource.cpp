#include "io/stores/ArraySource.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/stores/CopySamples.h"

namespace velum::io {

namespace {

constexpr std::size_t kMostOpen = 4096;  ///< arrays: some kilobytes each

/// 0 in all samples of a box.
void clear(const BrickBox& box, SampleType type, const SampleTarget& target) {
  constexpr std::byte kZero[8] = {};
  ChunkType bytes{ChunkType::Kind::Unsigned, int(sampleSize(type))};
  if (type == SampleType::Float64) bytes.kind = ChunkType::Kind::Float;
  copySamples(bytes, kZero, {}, box, target);
}

/// The box, no larger than what a chunk holds.
BrickBox within(BrickBox box, const FiveSizes& size) {
  auto cut = [](int count, std::uint64_t most) { return int(std::min(std::uint64_t(count), most)); };
  for (int axis = 0; axis < 3; ++axis) box.size[axis] = cut(box.size[axis], size[std::size_t(axis)]);
  box.channels = cut(box.channels, size[3]);
  box.timeSteps = cut(box.timeSteps, size[4]);
  return box;
}

}  // namespace

VoxelLevel levelOf(const ChunkArray& array, glm::ivec3 dims) {
  checkSizes(array);
  VoxelLevel level;
  for (int axis = 0; axis < 3; ++axis) {
    auto size = int(array.size[std::size_t(axis)]);
    level.dims[axis] = dims[axis] > 0 ? dims[axis] : size;
    level.brickSize[axis] = int(std::min<std::uint64_t>(array.chunk[std::size_t(axis)], std::uint64_t(size)));
    if (level.dims[axis] > size)
      refuse(array.path, fmt::format("has {} voxels along an axis, where {} are said", size, level.dims[axis]));
    level.brickSize[axis] = std::min(level.brickSize[axis], level.dims[axis]);
  }
  level.brickChannels = int(std::min(array.chunk[3], array.size[3]));
  level.brickTimeSteps = int(std::min(array.chunk[4], array.size[4]));
  return level;
}

StoredLevel storedAs(const ChunkArray& array, std::string key) {
  StoredLevel stored{std::move(key), array.type, {}, {}, array.packing};
  for (std::size_t axis = array.size.size(); axis-- > 0;)
    if (axis < 3 || array.size[axis] > 1) stored.chunk.push_back(array.chunk[axis]);
  return stored;
}

ArraySource::ArraySource(ArrayPyramid pyramid) : mIsWhole(pyramid.isWhole), mOpen(std::move(pyramid.open)) {
  mHead = std::move(pyramid.head);
  mLevels = std::move(pyramid.levels);
  mChannelWindows = std::move(pyramid.channelWindows);
  mFacts = std::move(pyramid.facts);
}

void ArraySource::check(const ChunkArray& array, int level) const {
  VoxelLevel found = levelOf(array, mLevels[std::size_t(level)].dims);
  if (found.brickSize != mLevels[std::size_t(level)].brickSize || sampleTypeOf(givenType(array.type)) != mHead.type)
    refuse(array.path, "its chunks or its type are not those of the first array of its level");
}

std::shared_ptr<const ChunkArray> ArraySource::arrayOf(const BrickAddress& address) const {
  std::tuple key(address.level, mIsWhole ? 0 : address.channel, mIsWhole ? 0 : address.timeStep);
  {
    std::lock_guard lock(mGuard);
    if (auto found = mArrays.find(key); found != mArrays.end()) return found->second;
  }
  auto array = std::apply(mOpen, key);
  if (array) check(*array, address.level);
  std::lock_guard lock(mGuard);
  if (mArrays.size() >= kMostOpen) mArrays.clear();
  return mArrays.emplace(key, std::move(array)).first->second;
}

void ArraySource::read(const BrickAddress& address, const SampleTarget& target) const {
  auto array = arrayOf(address);
  FiveSizes index{std::uint64_t(address.brick.x), std::uint64_t(address.brick.y), std::uint64_t(address.brick.z)};
  if (mIsWhole) index[3] = std::uint64_t(address.channel), index[4] = std::uint64_t(address.timeStep);
  auto chunk = array ? array->read(index) : std::nullopt;
  BrickBox box = boxOf(*this, address), there = chunk ? within(box, chunk->size) : BrickBox{};
  bool isWhole = there.size == box.size && there.channels == box.channels && there.timeSteps == box.timeSteps;
  if (!isWhole) clear(box, mHead.type, target);
  if (!chunk) return;
  SampleSteps steps;
  steps.x = array->type.bytes;
  steps.y = steps.x * std::ptrdiff_t(chunk->size[0]);
  steps.z = steps.y * std::ptrdiff_t(chunk->size[1]);
  steps.channel = steps.z * std::ptrdiff_t(chunk->size[2]);
  steps.timeStep = steps.channel * std::ptrdiff_t(chunk->size[3]);
  if (!copySamples(givenType(array->type), chunk->bytes.data(), steps, there, target))
    refuseWideNumbers(array->type, array->path.string());
}

}  // namespace velum::io
