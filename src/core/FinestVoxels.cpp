#include "core/FinestVoxels.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <mutex>

#include "core/Error.h"
#include "core/Parallel.h"
#include "core/VoxelSource.h"

namespace velum {

namespace {

/// A volume as one of its levels, without voxels.
Volume headOf(const Volume& volume, int level) {
  Volume head;
  const Volume& coarse = volume;
  head.dims = volume.finer->bricks->source().levels()[std::size_t(level)].dims;
  head.worldFromVoxel = worldFromLevel(volume, level);
  head.type = coarse.type;
  head.channels = coarse.channels;
  head.timeSteps = coarse.timeSteps;
  head.isColor = coarse.isColor;
  head.lengthUnit = coarse.lengthUnit;
  head.scale = coarse.scale;
  head.offset = coarse.offset;
  head.range = coarse.range;
  head.unit = coarse.unit;
  head.modality = coarse.modality;
  return head;
}

/// The same of a box of a volume in memory.
Volume copyBox(const Volume& volume, glm::ivec3 first, glm::ivec3 size, int channel, int timeStep) {
  Volume part;
  part.type = volume.type;
  part.channels = channel < 0 ? volume.channels : 1;
  part.dims = size;
  part.voxels.resize(timeStepBytes(part));
  std::size_t sample = sampleSize(volume.type), voxel = sample * std::size_t(volume.channels);
  std::size_t kept = sample * std::size_t(part.channels);
  const std::byte* from = volume.voxels.data() + std::size_t(timeStep) * timeStepBytes(volume);
  std::byte* to = part.voxels.data();
  for (int z = first.z; z < first.z + size.z; ++z)
    for (int y = first.y; y < first.y + size.y; ++y) {
      std::size_t row = (std::size_t(z) * std::size_t(volume.dims.y) + std::size_t(y)) * std::size_t(volume.dims.x);
      const std::byte* at = from + (row + std::size_t(first.x)) * voxel + std::size_t(std::max(channel, 0)) * sample;
      for (int x = 0; x < size.x; ++x, at += voxel, to += kept) std::memcpy(to, at, kept);
    }
  return part;
}

}  // namespace

FinestVoxels::FinestVoxels(const Volume& volume, int level) : mGrid(&volume) {
  if (!volume.finer) return;
  mLevel = level;
  mHead = std::make_shared<const Volume>(headOf(volume, level));
  mGrid = mHead.get();
  mBricks = volume.finer->bricks.get();
}

SampleRun FinestVoxels::run(glm::ivec3 voxel, int channel, int timeStep) const {
  auto place = [](glm::ivec3 at, glm::ivec3 dims) {
    return (std::size_t(at.z) * std::size_t(dims.y) + std::size_t(at.y)) * std::size_t(dims.x) + std::size_t(at.x);
  };
  SampleRun run;
  if (!mBricks) {
    run.samples = mGrid->voxels.data();
    run.stride = mGrid->channels;
    run.count = mGrid->dims.x - voxel.x;
    std::size_t step = std::size_t(timeStep) * voxelCount(*mGrid);
    run.first = (step + place(voxel, mGrid->dims)) * std::size_t(run.stride) + std::size_t(channel);
    return run;
  }
  const VoxelSource& source = mBricks->source();
  const VoxelLevel& level = source.levels()[std::size_t(mLevel)];
  BrickAddress address{mLevel, voxel / level.brickSize, channel / level.brickChannels, timeStep / level.brickTimeSteps};
  run.kept = mBricks->brick(address);
  BrickBox box = boxOf(source, address);
  std::size_t step = std::size_t(timeStep - box.timeStep) * std::size_t(box.size.x) * std::size_t(box.size.y) *
                     std::size_t(box.size.z);
  run.samples = run.kept->data();
  run.stride = box.channels;
  run.count = box.origin.x + box.size.x - voxel.x;
  run.first =
      (step + place(voxel - box.origin, box.size)) * std::size_t(run.stride) + std::size_t(channel - box.channel);
  return run;
}

double FinestVoxels::value(glm::ivec3 voxel, int channel, int timeStep) const {
  if (!mBricks) return valueAt(*mGrid, voxel, channel, timeStep);
  Volume one = read(voxel, glm::ivec3(1), channel, timeStep);
  return valueAt(one, glm::ivec3(0));
}

double FinestVoxels::valueOrNan(glm::ivec3 voxel, int channel, int timeStep) const {
  try {
    return value(voxel, channel, timeStep);
  } catch (const InputError&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

void FinestVoxels::describe(Volume& part, glm::ivec3 first, int channel) const {
  part.isColor = mGrid->isColor && channel < 0;
  part.worldFromVoxel = mGrid->worldFromVoxel;
  part.worldFromVoxel[3] = mGrid->worldFromVoxel * glm::dvec4(glm::dvec3(first), 1.0);
  part.lengthUnit = mGrid->lengthUnit;
  part.scale = mGrid->scale;
  part.offset = mGrid->offset;
  part.range = mGrid->range;
  part.unit = mGrid->unit;
  part.modality = mGrid->modality;
}

Volume FinestVoxels::read(glm::ivec3 first, glm::ivec3 size, int channel, int timeStep) const {
  glm::ivec3 end = glm::clamp(first + size, glm::ivec3(1), mGrid->dims);
  first = glm::clamp(first, glm::ivec3(0), end - 1);
  Volume part = mBricks ? mBricks->read({mLevel, first, end - first}, channel, timeStep)
                        : copyBox(*mGrid, first, end - first, channel, timeStep);
  describe(part, first, channel);
  return part;
}

Volume FinestVoxels::readAll(glm::ivec3 first, glm::ivec3 size, int channel, int timeStep, Progress& progress) const {
  if (!mBricks) return read(first, size, channel, timeStep);
  glm::ivec3 end = glm::clamp(first + size, glm::ivec3(1), mGrid->dims);
  first = glm::clamp(first, glm::ivec3(0), end - 1);
  Volume whole;
  whole.type = mGrid->type;
  whole.channels = channel < 0 ? mGrid->channels : 1;
  whole.dims = end - first;
  describe(whole, first, channel);
  whole.voxels.resize(timeStepBytes(whole));
  std::size_t voxel = sampleSize(whole.type) * std::size_t(whole.channels);
  glm::ivec3 brick = mBricks->source().levels()[std::size_t(mLevel)].brickSize;
  glm::ivec3 from = first / brick, bricks = (end - 1) / brick - from + 1;
  std::mutex telling;
  int done = 0, all = bricks.x * bricks.y * bricks.z;
  parallelFor(0, all, [&](int i) {
    if (progress.isCancelled()) return;
    glm::ivec3 at = (from + glm::ivec3(i % bricks.x, i / bricks.x % bricks.y, i / bricks.x / bricks.y)) * brick;
    glm::ivec3 low = glm::max(at, first), high = glm::min(at + brick, end), n = high - low;
    Volume part = mBricks->read({mLevel, low, n}, channel, timeStep);
    for (int z = 0; z < n.z; ++z)
      for (int y = 0; y < n.y; ++y) {
        glm::ivec3 to = low - first + glm::ivec3(0, y, z);
        std::size_t row =
            (std::size_t(to.z) * std::size_t(whole.dims.y) + std::size_t(to.y)) * std::size_t(whole.dims.x) +
            std::size_t(to.x);
        std::size_t own = (std::size_t(z) * std::size_t(n.y) + std::size_t(y)) * std::size_t(n.x);
        std::memcpy(whole.voxels.data() + row * voxel, part.voxels.data() + own * voxel, std::size_t(n.x) * voxel);
      }
    std::lock_guard lock(telling);
    if (!progress.isCancelled()) progress.report(double(++done) / double(all), "Reading voxels");
  });
  progress.throwIfCancelled();
  return whole;
}

}  // namespace velum
