#include "render/section/SectionBricks.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <mutex>
#include <unordered_set>

#include "core/Parallel.h"
#include "render/residency/PageGrid.h"

namespace velum::render {

namespace {

/// A raw sample in a brick.
template <class T>
double rawAt(const std::byte* bytes, std::size_t index) {
  T value;
  std::memcpy(&value, bytes + index * sizeof(T), sizeof(T));
  return double(value);
}

using Raw = double (*)(const std::byte*, std::size_t);
Raw rawReader(SampleType type) {
  switch (type) {
    case SampleType::UInt8:
      return rawAt<std::uint8_t>;
    case SampleType::Int8:
      return rawAt<std::int8_t>;
    case SampleType::UInt16:
      return rawAt<std::uint16_t>;
    case SampleType::Int16:
      return rawAt<std::int16_t>;
    case SampleType::UInt32:
      return rawAt<std::uint32_t>;
    case SampleType::Int32:
      return rawAt<std::int32_t>;
    case SampleType::Float32:
      return rawAt<float>;
    case SampleType::Float64:
      break;
  }
  return rawAt<double>;
}

}  // namespace

SectionBricks::SectionBricks(const Volume& volume, std::vector<int> channels, int timeStep,
                             const scene::SectionPlane& plane, glm::ivec2 size, bool waits)
    : mVolume(volume),
      mTimeStep(timeStep),
      mOwnLevel(volume.finer->level),
      mLevel(levelForPixel(volume, plane.lengthPerPixel)),
      mSize(size) {
  if (!isFiner()) return;
  BrickCache& bricks = *volume.finer->bricks;
  const VoxelLevel& level = bricks.source().levels()[std::size_t(mLevel)];
  mDims = level.dims;
  mBrickSize = level.brickSize;
  mGrid = bricksOf(level);
  mPath.emplace(plane, mDims, worldFromLevel(volume, mLevel));
  std::unordered_set<std::uint64_t> wanted;
  std::mutex joining;
  parallelForRanges(0, size.y, 16, [&](int first, int end) {
    std::vector<std::uint64_t> keys;
    for (int y = first; y < end; ++y) collect(y, keys);
    std::lock_guard lock(joining);
    wanted.insert(keys.begin(), keys.end());
  });
  std::unordered_set<int> channelBricks;
  for (int channel : channels) channelBricks.insert(channel / level.brickChannels);
  std::vector<BrickAddress> addresses;
  std::vector<std::uint64_t> keys(wanted.begin(), wanted.end());
  std::sort(keys.begin(), keys.end());
  for (std::uint64_t key : keys)
    for (int channelBrick : channelBricks) {
      auto x = std::uint64_t(mGrid.x), y = std::uint64_t(mGrid.y);
      addresses.push_back({mLevel,
                           {int(key % x), int(key / x % y), int(key / (x * y))},
                           channelBrick,
                           timeStep / level.brickTimeSteps});
    }
  std::vector<char> isMissing(addresses.size(), 0);
  parallelFor(std::size_t(0), addresses.size(), [&](std::size_t i) {
    auto brick = waits ? bricks.brick(addresses[i]) : bricks.find(addresses[i]);
    std::lock_guard lock(joining);
    if (brick)
      mHeld[keyOf(addresses[i].brick, addresses[i].channel)] = {brick, boxOf(bricks.source(), addresses[i])};
    else
      isMissing[i] = 1;
  });
  for (std::size_t i = 0; i < addresses.size(); ++i)
    if (isMissing[i]) mMissing.push_back(addresses[i]);
}

std::uint64_t SectionBricks::keyOf(glm::ivec3 brick, int channelBrick) const {
  return ((std::uint64_t(channelBrick) * std::uint64_t(mGrid.z) + std::uint64_t(brick.z)) * std::uint64_t(mGrid.y) +
          std::uint64_t(brick.y)) *
             std::uint64_t(mGrid.x) +
         std::uint64_t(brick.x);
}

/// Bricks of the voxels around each pixel of a row.
void SectionBricks::collect(int y, std::vector<std::uint64_t>& keys) const {
  GridRow row = mPath->row(y, mSize.x);
  glm::ivec3 lastLow(-1), lastHigh(-1);
  for (int x = row.first; x < row.last; ++x) {
    glm::dvec3 at = placeIn(row.at, mDims);
    glm::ivec3 low = glm::ivec3(at) / mBrickSize, high = glm::min(glm::ivec3(at) + 1, mDims - 1) / mBrickSize;
    for (std::size_t i = 0; i < 3; ++i) row.at[i] += row.step[i];
    if (low == lastLow && high == lastHigh) continue;
    lastLow = low, lastHigh = high;
    for (int k = low.z; k <= high.z; ++k)
      for (int j = low.y; j <= high.y; ++j)
        for (int i = low.x; i <= high.x; ++i) keys.push_back(keyOf({i, j, k}, 0));
  }
}

const SectionBricks::Held* SectionBricks::heldAt(glm::ivec3 brick, int channelBrick) const {
  auto found = mHeld.find(keyOf(brick, channelBrick));
  return found == mHeld.end() ? nullptr : &found->second;
}

void SectionBricks::sampleRow(int y, int channel, bool interpolate, double scale, double offset, float* out) const {
  if (!isFiner()) return;
  const VoxelSource& source = mVolume.finer->bricks->source();
  int perBrick = source.levels()[std::size_t(mLevel)].brickChannels;
  Raw raw = rawReader(source.head().type);
  glm::ivec3 lastBrick(-1);
  const Held* held = nullptr;
  // A raw value; false where its brick is not there.
  auto valueIn = [&](glm::ivec3 voxel, double& value) {
    glm::ivec3 brick = voxel / mBrickSize;
    if (brick != lastBrick) held = heldAt(lastBrick = brick, channel / perBrick);
    if (!held) return false;
    const BrickBox& box = held->box;
    glm::ivec3 in = voxel - box.origin;
    std::size_t index = std::size_t(mTimeStep - box.timeStep) * std::size_t(box.size.z) + std::size_t(in.z);
    index = (index * std::size_t(box.size.y) + std::size_t(in.y)) * std::size_t(box.size.x) + std::size_t(in.x);
    value = raw(held->bytes->data(), index * std::size_t(box.channels) + std::size_t(channel - box.channel));
    return true;
  };
  GridRow row = mPath->row(y, mSize.x);
  for (int x = row.first; x < row.last; ++x) {
    glm::dvec3 at = placeIn(row.at, mDims);
    for (std::size_t i = 0; i < 3; ++i) row.at[i] += row.step[i];
    double value = 0.0;
    if (!interpolate) {
      if (valueIn(glm::ivec3(at + 0.5), value)) out[x] = float(value * scale + offset);
      continue;
    }
    glm::ivec3 low(at), high = glm::min(low + 1, mDims - 1);
    glm::dvec3 f = at - glm::dvec3(low);
    double sum = 0.0;
    bool isThere = true;
    for (int i = 0; i < 8 && isThere; ++i) {
      glm::dvec3 weights(i & 1 ? f.x : 1.0 - f.x, i & 2 ? f.y : 1.0 - f.y, i & 4 ? f.z : 1.0 - f.z);
      double weight = weights.x * weights.y * weights.z;
      if (weight == 0.0) continue;
      isThere = valueIn({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z}, value);
      sum += weight * value;
    }
    if (isThere) out[x] = float(sum * scale + offset);
  }
}

}  // namespace velum::render
