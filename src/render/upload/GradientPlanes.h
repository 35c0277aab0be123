#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "render/upload/VolumeTexels.h"

namespace velum::render {

/// Planes of numbers of which some are kept, while those that are asked for go upwards.
struct SlidingPlanes {
  int low = 0;
  std::vector<float> numbers;

  /// Planes low..high: those that are not there yet are made, those below are dropped.
  /// @param make  make(first, last) returns planes first..last
  template <class Make>
  const float* slide(int askedLow, int askedHigh, std::size_t planeSize, const Make& make);
};

/// The gradients of a level, plane by plane.
///
/// They are differences over two voxels along an axis, of values that are smoothed across it by 1 2 1 both ways
/// (takeDifferences()). Edges that are as sharp as voxels still show rows and slices as wood grain with these: the
/// slope of a plane that leans by 20 degrees comes out between 17 and 20, as its distance from the voxels varies. So
/// the direction is smoothed again, by a Gaussian of one voxel, unless it turns away by more than 10 to 20 degrees: the
/// normals of a thin vessel are not taken from the bone beside it. Where voxels are long, the Gaussian is wider along
/// the short axes: slices show as stairs where a gradient reaches farther across them than along them. The length stays
/// as it was, so that what is modulated by it keeps its look.
class GradientPlanes {
 public:
  /// @param source  of values, not colours; outlives this
  /// @param finer   texels per voxel along each axis; between voxels differences are splines, as values are
  ///                (smoothPlanes()). Those of the spline itself swing from slice to slice
  GradientPlanes(const VolumeTexels& source, glm::ivec3 finer) : mSource(&source), mFiner(finer) {}

  /// Planes z0..z1, three numbers a texel, raw values per texel. Cheap where calls go upwards.
  std::vector<float> planes(int z0, int z1);

 private:
  std::vector<float> narrowPlanes(int low, int high) const;
  std::vector<float> widePlanes(int low, int high);

  const VolumeTexels* mSource;
  glm::ivec3 mFiner;
  SlidingPlanes mNarrow, mAcross, mWide;  ///< As they are, smoothed along x and y, and along z.
};

}  // namespace velum::render
