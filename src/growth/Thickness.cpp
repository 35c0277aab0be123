#include "growth/Thickness.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "core/Parallel.h"

namespace velum::growth {

namespace {

/// A step to a neighbour: in memory, and how long.
struct Step {
  std::ptrdiff_t offset;
  int length;
};

/// To the 13 neighbours that come before a voxel in memory.
std::array<Step, 13> stepsBefore(const RoomyBox& box, const glm::dmat3& worldFromVoxel) {
  auto lengthOf = [&](glm::ivec3 to) { return glm::length(worldFromVoxel * glm::dvec3(to)); };
  double shortest = std::min({lengthOf({1, 0, 0}), lengthOf({0, 1, 0}), lengthOf({0, 0, 1})});
  auto [x, y, z] = box.steps();
  std::array<Step, 13> out{};
  std::size_t count = 0;
  for (int dz = -1; dz <= 0; ++dz)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        std::ptrdiff_t offset = dx * x + dy * y + dz * z;
        if (offset >= 0) continue;
        double length = kLengthUnit * lengthOf({dx, dy, dz}) / shortest;
        out[count++] = {offset, int(std::lround(std::min(length, double(kFarAway))))};
      }
  return out;
}

template <class Body>
void forRowsForward(glm::ivec3 dims, const Body& body) {
  for (int z = 1; z < dims.z - 1; ++z)
    for (int y = 1; y < dims.y - 1; ++y) body(y, z);
}

template <class Body>
void forRowsBackward(glm::ivec3 dims, const Body& body) {
  for (int z = dims.z - 2; z > 0; --z)
    for (int y = dims.y - 2; y > 0; --y) body(y, z);
}

std::size_t rowStart(glm::ivec3 dims, int y, int z) {
  return (std::size_t(z) * std::size_t(dims.y) + std::size_t(y)) * std::size_t(dims.x);
}

}  // namespace

void spreadLengths(const RoomyBox& box, const glm::dmat3& worldFromVoxel, Lengths& lengths) {
  glm::ivec3 dims = box.dims();
  auto before = stepsBefore(box, worldFromVoxel);
  auto lower = [&](std::uint16_t* at, std::ptrdiff_t sign) {
    int least = *at;
    if (least == 0) return;
    for (const Step& step : before) least = std::min(least, int(at[sign * step.offset]) + step.length);
    *at = std::uint16_t(least);
  };
  forRowsForward(dims, [&](int y, int z) {
    std::uint16_t* row = lengths.data() + rowStart(dims, y, z);
    for (int x = 1; x < dims.x - 1; ++x) lower(row + x, 1);
  });
  forRowsBackward(dims, [&](int y, int z) {
    std::uint16_t* row = lengths.data() + rowStart(dims, y, z);
    for (int x = dims.x - 2; x > 0; --x) lower(row + x, -1);
  });
}

std::vector<std::uint8_t> thicknessLevels(const RoomyBox& box, const glm::dmat3& worldFromVoxel, const Lengths& depths,
                                          const Progress& progress) {
  std::vector<std::uint8_t> levels(depths.size());
  auto isKnown = [](std::uint16_t depth) { return depth < kFarAway; };
  int deepest = 0;
  for (auto depth : depths)
    if (isKnown(depth)) deepest = std::max(deepest, int(depth));
  int count = int(std::log(std::max(deepest, kLengthUnit) / double(kLengthUnit)) / std::log(kThicker));
  std::mutex merging;
  // A ball of each radius around each voxel that is as deep: one level's ball after the other, as many at a time as
  // there are cores.
  parallelFor(1, count + 1, [&](int level) {
    if (progress.isCancelled()) return;
    auto radius = std::uint16_t(std::lround(kLengthUnit * std::pow(kThicker, level)));
    Lengths away(depths.size());
    for (std::size_t i = 0; i < depths.size(); ++i) away[i] = depths[i] >= radius ? 0 : kFarAway;
    spreadLengths(box, worldFromVoxel, away);
    std::lock_guard lock(merging);
    for (std::size_t i = 0; i < depths.size(); ++i)
      if (away[i] < radius) levels[i] = std::max(levels[i], std::uint8_t(level));
  });
  progress.throwIfCancelled();
  return levels;
}

}  // namespace velum::growth
