#include "core/VoxelSource.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <mutex>

#include "core/Parallel.h"

namespace velum {

namespace {

constexpr int kBrickSize = 64;  ///< of a volume in memory

int divideUp(int count, int size) { return int((std::int64_t(count) + size - 1) / size); }

/// A level's volume, whose voxels are laid out as `Volume::voxels` says.
SampleTarget targetIn(Volume& volume, const BrickBox& box) {
  auto sample = std::ptrdiff_t(sampleSize(volume.type));
  SampleTarget target;
  target.channel = sample;
  target.x = sample * volume.channels;
  target.y = target.x * volume.dims.x;
  target.z = target.y * volume.dims.y;
  target.timeStep = target.z * volume.dims.z;
  target.first = volume.voxels.data() + box.origin.x * target.x + box.origin.y * target.y + box.origin.z * target.z +
                 box.channel * target.channel + box.timeStep * target.timeStep;
  return target;
}

/// All bricks of a level, by number.
class BrickList {
 public:
  BrickList(const VoxelSource& source, int level)
      : mLevel(level), mGrid(bricksOf(source.levels()[std::size_t(level)])), mChannels(channelBricksOf(source, level)) {
    count = std::size_t(mGrid.x) * std::size_t(mGrid.y) * std::size_t(mGrid.z) * std::size_t(mChannels) *
            std::size_t(timeBricksOf(source, level));
  }
  BrickAddress operator[](std::size_t i) const {
    auto take = [&](int size) {
      int index = int(i % std::size_t(size));
      i /= std::size_t(size);
      return index;
    };
    BrickAddress address{mLevel};
    for (int axis = 0; axis < 3; ++axis) address.brick[axis] = take(mGrid[axis]);
    address.channel = take(mChannels);
    address.timeStep = int(i);
    return address;
  }
  std::size_t count = 0;

 private:
  int mLevel;
  glm::ivec3 mGrid;
  int mChannels;
};

/// Copies samples of one size from one layout to another.
template <class Sample>
void copySamples(const BrickBox& box, const SampleTarget& from, const SampleTarget& to) {
  for (int t = 0; t < box.timeSteps; ++t)
    for (int c = 0; c < box.channels; ++c)
      for (int z = 0; z < box.size.z; ++z)
        for (int y = 0; y < box.size.y; ++y) {
          const std::byte* a = from.first + t * from.timeStep + c * from.channel + z * from.z + y * from.y;
          std::byte* b = to.first + t * to.timeStep + c * to.channel + z * to.z + y * to.y;
          if (from.x == std::ptrdiff_t(sizeof(Sample)) && to.x == from.x)
            std::memcpy(b, a, std::size_t(box.size.x) * sizeof(Sample));
          else
            for (int x = 0; x < box.size.x; ++x) std::memcpy(b + x * to.x, a + x * from.x, sizeof(Sample));
        }
}

}  // namespace

std::optional<glm::dvec2> VoxelSource::range(const BrickAddress&) const { return std::nullopt; }

glm::ivec3 bricksOf(const VoxelLevel& level) {
  glm::ivec3 grid;
  for (int axis = 0; axis < 3; ++axis) grid[axis] = divideUp(level.dims[axis], level.brickSize[axis]);
  return grid;
}

int channelBricksOf(const VoxelSource& source, int level) {
  return divideUp(source.head().channels, source.levels()[std::size_t(level)].brickChannels);
}

int timeBricksOf(const VoxelSource& source, int level) {
  return divideUp(source.head().timeSteps, source.levels()[std::size_t(level)].brickTimeSteps);
}

BrickBox boxOf(const VoxelSource& source, const BrickAddress& address) {
  const VoxelLevel& level = source.levels()[std::size_t(address.level)];
  BrickBox box;
  box.origin = address.brick * level.brickSize;
  box.size = glm::min(level.brickSize, level.dims - box.origin);
  box.channel = address.channel * level.brickChannels;
  box.channels = std::min(level.brickChannels, source.head().channels - box.channel);
  box.timeStep = address.timeStep * level.brickTimeSteps;
  box.timeSteps = std::min(level.brickTimeSteps, source.head().timeSteps - box.timeStep);
  return box;
}

void copySamples(const BrickBox& box, std::size_t sampleBytes, const SampleTarget& from, const SampleTarget& to) {
  switch (sampleBytes) {
    case 1:
      return copySamples<std::uint8_t>(box, from, to);
    case 2:
      return copySamples<std::uint16_t>(box, from, to);
    case 4:
      return copySamples<std::uint32_t>(box, from, to);
    default:
      return copySamples<std::uint64_t>(box, from, to);
  }
}

double levelBytes(const VoxelSource& source, int level) {
  const Volume& head = source.head();
  glm::dvec3 dims = source.levels()[std::size_t(level)].dims;
  return dims.x * dims.y * dims.z * head.channels * head.timeSteps * double(sampleSize(head.type));
}

std::optional<int> levelWithin(const VoxelSource& source, double bytes) {
  for (int level = 0; level < int(source.levels().size()); ++level)
    if (levelBytes(source, level) <= bytes) return level;
  return std::nullopt;
}

Volume readLevel(const VoxelSource& source, int level, Progress& progress) {
  progress.throwIfCancelled();
  Volume volume = source.head();
  volume.dims = source.levels()[std::size_t(level)].dims;
  volume.worldFromVoxel = source.levels()[std::size_t(level)].worldFromVoxel;
  volume.voxels.resize(timeStepBytes(volume) * std::size_t(volume.timeSteps));
  BrickList bricks(source, level);
  std::mutex telling;
  std::size_t done = 0;
  parallelFor(std::size_t(0), bricks.count, [&](std::size_t i) {
    progress.throwIfCancelled();
    BrickAddress address = bricks[i];
    source.read(address, targetIn(volume, boxOf(source, address)));
    std::lock_guard lock(telling);
    progress.report(double(++done) / double(bricks.count), "Reading voxels");
  });
  return volume;
}

VolumeSource::VolumeSource(Shared<Volume> volume) : VolumeSource(*volume) { mKept = std::move(volume); }

VolumeSource::VolumeSource(const Volume& volume) : mVolume(&volume) {
  mLevels = {{volume.dims, glm::min(volume.dims, glm::ivec3(kBrickSize)), volume.channels, 1, volume.worldFromVoxel}};
}

void VolumeSource::read(const BrickAddress& address, const SampleTarget& target) const {
  BrickBox box = boxOf(*this, address);
  // It is only read from: a target has no other kind of pointer.
  SampleTarget from = targetIn(const_cast<Volume&>(*mVolume), box);
  copySamples(box, sampleSize(mVolume->type), from, target);
}

}  // namespace velum
