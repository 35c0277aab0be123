#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "render/upload/GradientTexels.h"
#include "render/upload/VolumeTexels.h"

namespace velum::render {

/// Planes of numbers, made when asked for; some are kept, for callers that ask for planes in rising order.
struct SlidingPlanes {
  int low = 0;
  std::vector<float> numbers;

  /// Gives planes askedLow..askedHigh: planes that are missing are made, planes below are dropped.
  /// @param make  make(first, last) returns planes first..last
  template <class Make>
  const float* slide(int askedLow, int askedHigh, std::size_t planeSize, const Make& make);
};

/// Widths of the Gaussian by which gradients are smoothed along each axis, voxels.
glm::dvec3 gradientWidths(glm::dvec3 spacing, glm::ivec3 dims);

/// How many voxels away, along each axis, values may lie that have a say in the gradient of a voxel, as it is packed.
/// @param dims  of the volume: along an axis of one voxel nothing is smoothed
glm::ivec3 gradientReach(glm::dvec3 spacing, glm::ivec3 dims);

/// Gradients of planes z0..z1 of values that are not refined, as packGradients() makes them of GradientPlanes', block
/// by block on all cores. @param longestGradient  the length that a full-length texel stands for, raw values
PackedGradients planeGradients(const VolumeTexels& source, int z0, int z1, double longestGradient);

/// The gradients of a level, plane by plane.
///
/// They are differences over two voxels along an axis, of values that are smoothed by 1 2 1 along both other axes
/// (takeDifferences()). With these alone, edges as sharp as voxels still show rows and slices like wood grain: a plane
/// that leans by 20 degrees seems to lean by 17 to 20, as its distance from the voxels varies. So the direction is
/// smoothed again, by a Gaussian of one voxel, unless it turns away by more than 10 to 20 degrees: the normals of a
/// thin vessel are not taken from the bone beside it. Where voxels are long, the Gaussian is wider along the short
/// axes: slices show as stairs where a gradient reaches farther across them than along them. The gradients' lengths are
/// not smoothed again, so that opacity modulated by them keeps its look.
class GradientPlanes {
 public:
  /// @param source  texels of values, not colours; must outlive this object
  /// @param finer  texels per voxel along each axis; between voxels differences are splines, as values are
  ///                (smoothPlanes()). Those of the spline itself swing from slice to slice
  GradientPlanes(const VolumeTexels& source, glm::ivec3 finer) : mSource(&source), mFiner(finer) {}

  /// Planes z0..z1, three numbers a texel, raw values per texel. Cheap where calls go upwards.
  std::vector<float> planes(int z0, int z1);

 private:
  std::vector<float> narrowPlanes(int low, int high) const;
  std::vector<float> widePlanes(int low, int high);

  const VolumeTexels* mSource;
  glm::ivec3 mFiner;
  SlidingPlanes mNarrow, mAcross, mWide;  ///< Gradients as they are; smoothed along x and y; and along z, too.
};

}  // namespace velum::render
