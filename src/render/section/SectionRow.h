#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "core/Volume.h"
#include "scene/SectionPlane.h"

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

/// The place of a pixel among voxels, whose middles lie at whole numbers; on the grid.
inline glm::dvec3 placeIn(const std::array<std::int64_t, 3>& at, glm::ivec3 dims) {
  constexpr double kOne = 4294967296.0;
  return glm::clamp(glm::dvec3(at[0], at[1], at[2]) / kOne, glm::dvec3(0.0), glm::dvec3(dims - 1));
}

}  // namespace velum::render
