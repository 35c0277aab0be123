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

/// How the pixels of a section run through a grid of voxels.
class GridPath {
 public:
  GridPath(const scene::SectionPlane& plane, glm::ivec3 dims, const glm::dmat4& worldFromVoxel);
  /// @param width  pixels of the row
  GridRow row(int y, int width) const;

 private:
  glm::ivec3 mDims;
  glm::dvec3 mOrigin, mAcross, mDown;  ///< Voxel coordinates of the section's corner; steps from pixel to pixel.
};

/// Samples of one channel along a row: out[x] = raw * scale + offset for x in first..last-1. A value that is not a
/// number stays so.
/// @param interpolate  trilinear, the edge voxels reaching to the box's sides; else the nearest voxel
void sampleRow(const Volume& volume, int channel, int timeStep, const GridRow& row, bool interpolate, double scale,
               double offset, float* out);

/// The place of a pixel in voxel coordinates (voxels' middles are at whole numbers), clamped to the grid's outermost
/// middles.
inline glm::dvec3 placeIn(const std::array<std::int64_t, 3>& at, glm::ivec3 dims) {
  constexpr double kOne = 4294967296.0;
  return glm::clamp(glm::dvec3(at[0], at[1], at[2]) / kOne, glm::dvec3(0.0), glm::dvec3(dims - 1));
}

}  // namespace velum::render
