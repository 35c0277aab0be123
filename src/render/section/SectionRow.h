#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "velum/core/Volume.h"
#include "velum/scene/SectionPlane.h"

namespace velum::render {

/// The pixels of one row of a section that lie in a grid's box, and their voxel coordinates in fixed point (32 bits
/// behind the point), so that a step along the row is three additions and has no drift.
struct GridRow {
  int first = 0, last = 0;  ///< Pixels first..last-1.
  std::array<std::int64_t, 3> at{}, step{};
};

/// How a section's pixels run through a grid.
class GridPath {
 public:
  GridPath(const scene::SectionPlane& plane, glm::ivec3 dims, const glm::dmat4& worldFromVoxel);
  /// @param width  pixels of the row
  GridRow row(int y, int width) const;

 private:
  glm::ivec3 mDims;
  glm::dvec3 mOrigin, mAcross, mDown;  ///< Voxel coordinates of the corner; steps a pixel.
};

/// Samples of one channel along a row: out[x] = raw * scale + offset for x in first..last-1. Not a number stays that.
/// @param interpolate  trilinear, the edge voxels reaching to the box's sides; else the nearest voxel
void sampleRow(const Volume& volume, int channel, int timeStep, const GridRow& row, bool interpolate, double scale,
               double offset, float* out);

/// The nearest voxel at the row's position, inside the grid.
inline glm::ivec3 nearestVoxel(const std::array<std::int64_t, 3>& at, glm::ivec3 dims) {
  constexpr std::int64_t kHalf = std::int64_t(1) << 31;
  glm::ivec3 voxel(int((at[0] + kHalf) >> 32), int((at[1] + kHalf) >> 32), int((at[2] + kHalf) >> 32));
  return glm::clamp(voxel, glm::ivec3(0), dims - 1);
}

}  // namespace velum::render
