#include "io/stores/PyramidPlan.h"

#include <algorithm>
#include <cmath>

namespace velum::io {

namespace {

constexpr int kCoarsest = 128;                 ///< most voxels of the last level along an axis
constexpr std::size_t kShardBytes = 32 << 20;  ///< most of a shard, before it is packed
constexpr int kShardEdge = 8;                  ///< most bricks of a shard along x and y

glm::ivec3 brickFor(glm::ivec3 dims, int edge) {
  glm::ivec3 brick = glm::min(dims, glm::ivec3(edge));
  std::int64_t most = std::int64_t(edge) * edge * edge;
  // What is thin gets broader bricks.
  for (bool grows = true; grows;) {
    grows = false;
    for (int axis = 0; axis < 3; ++axis) {
      glm::ivec3 larger = brick;
      larger[axis] *= 2;
      if (larger[axis] > dims[axis] || std::int64_t(larger.x) * larger.y * larger.z > most) continue;
      brick = larger;
      grows = true;
    }
  }
  return brick;
}

glm::ivec3 shardFor(glm::ivec3 dims, glm::ivec3 brick, std::size_t sampleBytes) {
  glm::ivec3 shard = brick;
  auto bytes = [&](glm::ivec3 of) { return std::size_t(of.x) * std::size_t(of.y) * std::size_t(of.z) * sampleBytes; };
  for (int bricks = 2; bricks <= kShardEdge; bricks *= 2)
    for (int axis : {0, 1}) {
      glm::ivec3 larger = shard;
      larger[axis] = brick[axis] * std::min(bricks, (dims[axis] + brick[axis] - 1) / brick[axis]);
      if (bytes(larger) <= kShardBytes) shard = larger;
    }
  return shard;
}

/// Which axes are halved after a level; none after the last.
glm::ivec3 factorAfter(const PlannedLevel& level, glm::dvec3 spacing) {
  glm::ivec3 factor(1);
  if (std::max({level.dims.x, level.dims.y, level.dims.z}) <= kCoarsest) return factor;
  glm::dvec3 edges = spacing * level.scale;
  double shortest = HUGE_VAL;
  for (int axis = 0; axis < 3; ++axis)
    if (level.dims[axis] > 1) shortest = std::min(shortest, edges[axis]);
  for (int axis = 0; axis < 3; ++axis)
    if (level.dims[axis] > 1 && edges[axis] <= shortest * std::sqrt(2.0)) factor[axis] = 2;
  return factor;
}

}  // namespace

double blockFactor(double finest, double coarser) {
  double ratio = finest / coarser, whole = std::round(ratio);
  bool isWhole = std::floor(finest / whole) <= coarser && coarser <= std::ceil(finest / whole);
  return isWhole ? whole : ratio;
}

std::vector<PlannedLevel> planPyramid(glm::ivec3 dims, glm::dvec3 spacing, int edge, std::size_t sampleBytes) {
  std::vector<PlannedLevel> levels;
  PlannedLevel level;
  level.dims = dims;
  for (;;) {
    level.brick = brickFor(level.dims, edge);
    level.shard = shardFor(level.dims, level.brick, sampleBytes);
    levels.push_back(level);
    level.factor = factorAfter(level, spacing);
    if (level.factor == glm::ivec3(1)) return levels;
    level.firstCentre += level.scale * glm::dvec3(level.factor - 1) / 2.0;
    level.scale *= glm::dvec3(level.factor);
    level.dims = (level.dims + level.factor - 1) / level.factor;
  }
}

}  // namespace velum::io
