#include "io/stores/ReadBox.h"

#include <algorithm>
#include <cstring>

#include "core/Parallel.h"

namespace velum::io {

namespace {

/// First index and size of a box along its five axes.
struct Extent {
  int first[5], size[5];
};
Extent extentOf(const BrickBox& box) {
  return {{box.origin.x, box.origin.y, box.origin.z, box.channel, box.timeStep},
          {box.size.x, box.size.y, box.size.z, box.channels, box.timeSteps}};
}

bool isInside(const Extent& inner, const Extent& outer) {
  for (int i = 0; i < 5; ++i)
    if (inner.first[i] < outer.first[i] || inner.first[i] + inner.size[i] > outer.first[i] + outer.size[i])
      return false;
  return true;
}

std::byte* at(const SampleTarget& target, const int (&index)[5]) {
  return target.first + index[0] * target.x + index[1] * target.y + index[2] * target.z + index[3] * target.channel +
         index[4] * target.timeStep;
}

/// Copies what two boxes share, row by row.
void copyShared(const BrickBox& from, const SampleTarget& source, const BrickBox& to, const SampleTarget& target) {
  Extent a = extentOf(from), b = extentOf(to);
  int low[5], count[5], inSource[5], inTarget[5];
  for (int i = 0; i < 5; ++i) {
    low[i] = std::max(a.first[i], b.first[i]);
    count[i] = std::min(a.first[i] + a.size[i], b.first[i] + b.size[i]) - low[i];
    inSource[i] = low[i] - a.first[i];
    inTarget[i] = low[i] - b.first[i];
  }
  const std::byte* first = at(source, inSource);
  std::byte* out = at(target, inTarget);
  for (int t = 0; t < count[4]; ++t)
    for (int c = 0; c < count[3]; ++c)
      for (int z = 0; z < count[2]; ++z)
        for (int y = 0; y < count[1]; ++y)
          std::memcpy(out + t * target.timeStep + c * target.channel + z * target.z + y * target.y,
                      first + t * source.timeStep + c * source.channel + z * source.z + y * source.y,
                      std::size_t(count[0]) * std::size_t(target.x));
}

}  // namespace

std::size_t bytesOf(const BrickBox& box, SampleType type) {
  return std::size_t(box.size.x) * std::size_t(box.size.y) * std::size_t(box.size.z) * std::size_t(box.channels) *
         std::size_t(box.timeSteps) * sampleSize(type);
}

SampleTarget targetIn(std::byte* samples, const BrickBox& box, SampleType type) {
  SampleTarget target;
  target.first = samples;
  target.x = std::ptrdiff_t(sampleSize(type));
  target.y = target.x * box.size.x;
  target.z = target.y * box.size.y;
  target.channel = target.z * box.size.z;
  target.timeStep = target.channel * box.channels;
  return target;
}

Bytes readBox(const VoxelSource& source, int level, const BrickBox& box, const Progress& progress) {
  Bytes samples;
  readBoxInto(samples, source, level, box, progress);
  return samples;
}

void readBoxInto(Bytes& samples, const VoxelSource& source, int level, const BrickBox& box, const Progress& progress) {
  SampleType type = source.head().type;
  samples.resize(bytesOf(box, type));
  SampleTarget target = targetIn(samples.data(), box, type);
  const VoxelLevel& of = source.levels()[std::size_t(level)];
  int brick[5] = {of.brickSize.x, of.brickSize.y, of.brickSize.z, of.brickChannels, of.brickTimeSteps};
  Extent wanted = extentOf(box);
  int first[5], count[5];
  std::size_t bricks = 1;
  for (int i = 0; i < 5; ++i) {
    first[i] = wanted.first[i] / brick[i];
    count[i] = (wanted.first[i] + wanted.size[i] - 1) / brick[i] - first[i] + 1;
    bricks *= std::size_t(count[i]);
  }
  parallelFor(std::size_t(0), bricks, [&](std::size_t number) {
    progress.throwIfCancelled();
    int index[5];
    for (int i = 0; i < 5; ++i) {
      index[i] = first[i] + int(number % std::size_t(count[i]));
      number /= std::size_t(count[i]);
    }
    BrickAddress address{level, {index[0], index[1], index[2]}, index[3], index[4]};
    BrickBox there = boxOf(source, address);
    if (isInside(extentOf(there), wanted)) {
      int offset[5];
      for (int i = 0; i < 5; ++i) offset[i] = extentOf(there).first[i] - wanted.first[i];
      SampleTarget direct = target;
      direct.first = at(target, offset);
      return source.read(address, direct);
    }
    Bytes whole(bytesOf(there, type));
    SampleTarget from = targetIn(whole.data(), there, type);
    source.read(address, from);
    copyShared(there, from, box, target);
  });
}

}  // namespace velum::io
