#include "core/BrickCache.h"

#include <algorithm>
#include <cstring>

namespace velum {

namespace {

/// Bytes of a sample, copied one by one along a row whose samples lie some bytes apart.
void copyRow(const std::byte* from, std::ptrdiff_t step, std::size_t size, int count, std::byte* to) {
  if (step == std::ptrdiff_t(size)) {
    std::memcpy(to, from, size * std::size_t(count));
    return;
  }
  for (int i = 0; i < count; ++i) std::memcpy(to + std::size_t(i) * size, from + i * step, size);
}

/// Repeats the outermost voxels of the part of a box that was filled: along x, then y, then z.
void spreadBorders(Volume& volume, glm::ivec3 low, glm::ivec3 high) {
  std::size_t voxel = sampleSize(volume.type) * std::size_t(volume.channels);
  std::size_t row = voxel * std::size_t(volume.dims.x), plane = row * std::size_t(volume.dims.y);
  std::byte* bytes = volume.voxels.data();
  for (int z = low.z; z < high.z; ++z) {
    for (int y = low.y; y < high.y; ++y) {
      std::byte* at = bytes + std::size_t(z) * plane + std::size_t(y) * row;
      for (int x = 0; x < low.x; ++x) std::memcpy(at + std::size_t(x) * voxel, at + std::size_t(low.x) * voxel, voxel);
      for (int x = high.x; x < volume.dims.x; ++x)
        std::memcpy(at + std::size_t(x) * voxel, at + std::size_t(high.x - 1) * voxel, voxel);
    }
    std::byte* at = bytes + std::size_t(z) * plane;
    for (int y = 0; y < low.y; ++y) std::memcpy(at + std::size_t(y) * row, at + std::size_t(low.y) * row, row);
    for (int y = high.y; y < volume.dims.y; ++y)
      std::memcpy(at + std::size_t(y) * row, at + std::size_t(high.y - 1) * row, row);
  }
  for (int z = 0; z < low.z; ++z)
    std::memcpy(bytes + std::size_t(z) * plane, bytes + std::size_t(low.z) * plane, plane);
  for (int z = high.z; z < volume.dims.z; ++z)
    std::memcpy(bytes + std::size_t(z) * plane, bytes + std::size_t(high.z - 1) * plane, plane);
}

/// The bricks in which voxels of a box lie, or, beyond the level, those that are repeated there. @param channel  -1:
/// all
std::vector<BrickAddress> bricksIn(const VoxelSource& source, const VoxelBox& box, int channel, int timeStep) {
  const VoxelLevel& level = source.levels()[std::size_t(box.level)];
  glm::ivec3 low = glm::clamp(box.origin, glm::ivec3(0), level.dims - 1);
  glm::ivec3 high = glm::clamp(box.origin + box.size, low + 1, level.dims);
  glm::ivec3 first = low / level.brickSize, last = (high - 1) / level.brickSize, at;
  int firstChannel = std::max(channel, 0), lastChannel = channel < 0 ? source.head().channels - 1 : channel;
  std::vector<BrickAddress> addresses;
  for (int c = firstChannel / level.brickChannels; c <= lastChannel / level.brickChannels; ++c)
    for (at.z = first.z; at.z <= last.z; ++at.z)
      for (at.y = first.y; at.y <= last.y; ++at.y)
        for (at.x = first.x; at.x <= last.x; ++at.x)
          addresses.push_back({box.level, at, c, timeStep / level.brickTimeSteps});
  return addresses;
}

}  // namespace

BrickCache::BrickCache(std::shared_ptr<const VoxelSource> source, std::size_t mostBytes)
    : mSource(std::move(source)), mMostBytes(mostBytes) {}

BrickCache::Key BrickCache::keyOf(const BrickAddress& address) const {
  Key key = Key(address.timeStep);
  key = key * Key(channelBricksOf(*mSource, address.level)) + Key(address.channel);
  glm::ivec3 grid = bricksOf(mSource->levels()[std::size_t(address.level)]);
  for (int axis = 2; axis >= 0; --axis) key = key * Key(grid[axis]) + Key(address.brick[axis]);
  return key * 64 + Key(address.level);
}

BrickCache::Brick BrickCache::readBrick(const BrickAddress& address) const {
  BrickBox box = boxOf(*mSource, address);
  const Volume& head = mSource->head();
  SampleTarget target;
  auto sample = std::ptrdiff_t(sampleSize(head.type));
  target.channel = sample;
  target.x = sample * box.channels;
  target.y = target.x * box.size.x;
  target.z = target.y * box.size.y;
  target.timeStep = target.z * box.size.z;
  auto bytes = std::make_shared<Bytes>(std::size_t(target.timeStep) * std::size_t(box.timeSteps));
  target.first = bytes->data();
  mSource->read(address, target);
  return bytes;
}

/// What was used longest ago goes. Who is still reading a brick keeps it alive.
void BrickCache::keep(Key key, std::size_t bytes) {
  auto found = mKept.find(key);
  if (found == mKept.end()) return;
  found->second.bytes = bytes;
  mBytes += bytes;
  dropBeyondBudget(&key);
}

/// @param keeps  a brick that stays; may be null
void BrickCache::dropBeyondBudget(const Key* keeps) {
  for (auto use = mUses.end(); mBytes > mMostBytes && use != mUses.begin();) {
    --use;
    auto old = mKept.find(*use);
    if ((keeps && old->first == *keeps) || old->second.bytes == 0) continue;
    mBytes -= old->second.bytes;
    mKept.erase(old);
    use = mUses.erase(use);
  }
}

BrickCache::Brick BrickCache::brick(const BrickAddress& address) {
  Key key = keyOf(address);
  std::promise<Brick> promise;
  std::shared_future<Brick> other;
  {
    std::lock_guard lock(mMutex);
    if (auto found = mKept.find(key); found != mKept.end()) {
      mUses.splice(mUses.begin(), mUses, found->second.use);
      other = found->second.brick;
    } else {
      mUses.push_front(key);
      mKept[key] = {promise.get_future().share(), 0, mUses.begin()};
    }
  }
  if (other.valid()) return other.get();
  try {
    Brick brick = readBrick(address);
    promise.set_value(brick);
    std::lock_guard lock(mMutex);
    keep(key, brick->size());
    return brick;
  } catch (...) {
    promise.set_exception(std::current_exception());
    std::lock_guard lock(mMutex);
    if (auto found = mKept.find(key); found != mKept.end()) {
      mUses.erase(found->second.use);
      mKept.erase(found);
    }
    throw;
  }
}

BrickCache::Brick BrickCache::find(const BrickAddress& address) {
  std::lock_guard lock(mMutex);
  auto found = mKept.find(keyOf(address));
  if (found == mKept.end() || found->second.bytes == 0) return nullptr;
  mUses.splice(mUses.begin(), mUses, found->second.use);
  return found->second.brick.get();
}

std::size_t BrickCache::mostBytes() const {
  std::lock_guard lock(mMutex);
  return mMostBytes;
}

void BrickCache::setMostBytes(std::size_t mostBytes) {
  std::lock_guard lock(mMutex);
  mMostBytes = mostBytes;
  dropBeyondBudget(nullptr);
}

std::size_t BrickCache::bytes() const {
  std::lock_guard lock(mMutex);
  return mBytes;
}

bool BrickCache::has(const VoxelBox& box, int channel, int timeStep) {
  auto addresses = bricksIn(*mSource, box, channel, timeStep);
  return std::all_of(addresses.begin(), addresses.end(), [&](const BrickAddress& one) { return bool(find(one)); });
}

Volume BrickCache::read(const VoxelBox& box, int channel, int timeStep) {
  const VoxelLevel& level = mSource->levels()[std::size_t(box.level)];
  Volume volume;
  const Volume& head = mSource->head();
  volume.dims = box.size;
  volume.type = head.type;
  volume.channels = channel < 0 ? head.channels : 1;
  volume.isColor = head.isColor && channel < 0;
  volume.scale = head.scale;
  volume.offset = head.offset;
  volume.range = head.range;
  volume.worldFromVoxel = level.worldFromVoxel;
  volume.worldFromVoxel[3] = level.worldFromVoxel * glm::dvec4(glm::dvec3(box.origin), 1.0);
  volume.voxels.resize(timeStepBytes(volume));
  auto size = sampleSize(head.type);
  glm::ivec3 low = glm::clamp(box.origin, glm::ivec3(0), level.dims - 1);
  glm::ivec3 high = glm::clamp(box.origin + box.size, low + 1, level.dims);  // one past the last
  int firstChannel = std::max(channel, 0), lastChannel = channel < 0 ? head.channels - 1 : channel;
  for (const BrickAddress& address : bricksIn(*mSource, box, channel, timeStep)) {
    Brick brick = this->brick(address);
    BrickBox held = boxOf(*mSource, address);
    glm::ivec3 from = glm::max(held.origin, low), to = glm::min(held.origin + held.size, high);
    auto step = std::ptrdiff_t(size) * held.channels;  // from voxel to voxel of the brick
    for (int c = std::max(firstChannel, held.channel); c <= std::min(lastChannel, held.channel + held.channels - 1);
         ++c)
      for (int z = from.z; z < to.z; ++z)
        for (int y = from.y; y < to.y; ++y) {
          glm::ivec3 in = glm::ivec3(from.x, y, z) - held.origin, out = glm::ivec3(from.x, y, z) - box.origin;
          std::size_t step4 = std::size_t(timeStep - held.timeStep) * std::size_t(held.size.z);
          std::size_t source =
              ((step4 + std::size_t(in.z)) * std::size_t(held.size.y) + std::size_t(in.y)) * std::size_t(held.size.x) +
              std::size_t(in.x);
          std::size_t target =
              (std::size_t(out.z) * std::size_t(box.size.y) + std::size_t(out.y)) * std::size_t(box.size.x) +
              std::size_t(out.x);
          const std::byte* a = brick->data() + source * std::size_t(step) + std::size_t(c - held.channel) * size;
          std::byte* b =
              volume.voxels.data() + (target * std::size_t(volume.channels) + std::size_t(c - firstChannel)) * size;
          if (volume.channels == 1)
            copyRow(a, step, size, to.x - from.x, b);
          else
            for (int x = 0; x < to.x - from.x; ++x)
              std::memcpy(b + std::size_t(x) * size * std::size_t(volume.channels), a + x * step, size);
        }
  }
  if (low != box.origin || high != box.origin + box.size) spreadBorders(volume, low - box.origin, high - box.origin);
  return volume;
}

glm::dmat4 worldFromLevel(const Volume& volume, int level) {
  const auto& levels = volume.finer->bricks->source().levels();
  // As the file says it, without what is rounded, where nobody has changed it.
  if (volume.worldFromVoxel == levels[std::size_t(volume.finer->level)].worldFromVoxel)
    return levels[std::size_t(level)].worldFromVoxel;
  return volume.worldFromVoxel * glm::inverse(levels[std::size_t(volume.finer->level)].worldFromVoxel) *
         levels[std::size_t(level)].worldFromVoxel;
}

double smallestSpacing(const glm::dmat4& worldFromVoxel) {
  glm::dmat3 m(worldFromVoxel);
  return std::min(glm::length(m[0]), std::min(glm::length(m[1]), glm::length(m[2])));
}

int levelForPixel(const Volume& volume, double pixel) {
  int level = volume.finer->level;
  while (level > 0 && smallestSpacing(worldFromLevel(volume, level)) > kVoxelsPerPixel * pixel) --level;
  return level;
}

glm::ivec3 finestDims(const Volume& volume) {
  return volume.finer ? volume.finer->bricks->source().levels().front().dims : volume.dims;
}

glm::dvec3 finestSpacing(const Volume& volume) {
  if (!volume.finer) return spacingOf(volume);
  glm::dmat4 axes = worldFromLevel(volume, 0);
  return {glm::length(glm::dvec3(axes[0])), glm::length(glm::dvec3(axes[1])), glm::length(glm::dvec3(axes[2]))};
}

}  // namespace velum
