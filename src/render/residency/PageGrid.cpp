#include "render/residency/PageGrid.h"

#include <algorithm>
#include <cmath>

#include "core/BrickCache.h"

namespace velum::render {

namespace {

/// True when a matrix moves and scales along axes alone.
bool isStraight(const glm::dmat4& m) {
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      if (row != column && std::abs(m[column][row]) > 1e-6 * std::abs(m[column][column])) return false;
  return true;
}

}  // namespace

PageGrid::PageGrid(const Volume& volume) {
  const auto& source = volume.finer->bricks->source().levels();
  glm::dmat4 worldFromFinest(1.0);
  for (int level = 0; level <= volume.finer->level; ++level) {
    PageLevel out;
    glm::dmat4 worldFromVoxel = worldFromLevel(volume, level);
    if (level == 0) worldFromFinest = worldFromVoxel;
    glm::dmat4 voxelFromFinest = glm::inverse(worldFromVoxel) * worldFromFinest;
    if (!isStraight(voxelFromFinest)) continue;
    out.dims = source[std::size_t(level)].dims;
    for (int axis = 0; axis < 3; ++axis) {
      double finest = source.front().dims[axis];
      // Of places among voxels whose corners are at whole numbers: index + 0.5.
      out.voxelsPerBox[axis] = voxelFromFinest[axis][axis] * finest;
      out.firstVoxel[axis] = voxelFromFinest[3][axis] - 0.5 * voxelFromFinest[axis][axis] + 0.5;
      out.shift[axis] = std::max(0, int(std::floor(-std::log2(voxelFromFinest[axis][axis]) + 0.005)));
      out.brickEdge[axis] = std::ldexp(kPageVoxels, out.shift[axis]) / finest;
      out.bricks[axis] = std::max(1, int(std::ceil(1.0 / out.brickEdge[axis] - 1e-9)));
      out.spacing[axis] = glm::length(glm::dvec3(worldFromVoxel[axis]));
    }
    out.voxelSize = std::min(out.spacing.x, std::min(out.spacing.y, out.spacing.z));
    out.worldFromTex = worldFromBox(out.dims, worldFromVoxel);
    mLevels.push_back(out);
    mSourceLevels.push_back(level);
  }
}

std::size_t PageGrid::finerBricks() const {
  std::size_t count = 0;
  for (int level = 0; level < coarsest(); ++level) {
    glm::ivec3 n = mLevels[std::size_t(level)].bricks;
    count += std::size_t(n.x) * std::size_t(n.y) * std::size_t(n.z);
  }
  return count;
}

glm::dvec3 PageGrid::edges(int level) const {
  const PageLevel& of = mLevels[std::size_t(level)];
  return of.brickEdge * of.voxelsPerBox;
}

glm::dvec3 PageGrid::lowCorner(const PageBrick& brick) const {
  return glm::dvec3(brick.at) * edges(brick.level) + mLevels[std::size_t(brick.level)].firstVoxel;
}

glm::ivec3 PageGrid::slotOrigin(const PageBrick& brick) const {
  return glm::ivec3(glm::floor(lowCorner(brick) - kGroupReach - 0.5 + 1e-6));
}

PageBrick PageGrid::parent(const PageBrick& brick, int level) const {
  glm::ivec3 shift = mLevels[std::size_t(level)].shift - mLevels[std::size_t(brick.level)].shift;
  PageBrick out{level, {}};
  for (int axis = 0; axis < 3; ++axis)
    out.at[axis] = std::min(brick.at[axis] >> std::max(0, shift[axis]), mLevels[std::size_t(level)].bricks[axis] - 1);
  return out;
}

}  // namespace velum::render
