#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "VolumeTexels.h"

namespace velum::render {

/// Texels per voxel along each axis that let linear interpolation between them pass for cubic interpolation between
/// voxels: as many as make a coarse axis as fine as the finest one; two along each where none is coarse. At most eight.
glm::ivec3 smoothFactors(const Volume& volume);

/// Planes z0..z1 of a volume with more texels than voxels: the cubic spline through the voxels ([THEVENAZ]),
/// beyond the border of which a voxel repeats.
/// Differs: beside an edge a value stays between the two voxels around it along an axis, as a spline that swings over
///          there would draw a shell of bone under the skin.
/// @param source  of level 1; its values, not colours
/// @param finer   texels per voxel along each axis, 1 or more
std::vector<float> smoothPlanes(const VolumeTexels& source, glm::ivec3 finer, int z0, int z1);

/// Differences of those texels, as takeDifferences() has them: taken of voxels, made as wide along every axis as along
/// the coarsest one by a Gaussian, and then cubic splines through the voxels as the values are. Narrower ones would
/// follow the spline, which swings from slice to slice: the normals of a ball in slices of five voxels are 5.2 degrees
/// off by its own derivative, 2.1 without splines and 1.4 so. They are as long as narrow ones are.
class SmoothGradients {
 public:
  /// @param source  outlives this
  SmoothGradients(const VolumeTexels& source, glm::ivec3 finer) : mSource(&source), mFiner(finer) {}

  /// Planes z0..z1, three numbers a texel, per texel. Cheap where calls go upwards.
  std::vector<float> planes(int z0, int z1);

 private:
  std::vector<float> widePlanes(int low, int high) const;

  const VolumeTexels* mSource;
  glm::ivec3 mFiner;
  int mLow = 0, mHigh = 0;   ///< The planes of voxels that are kept.
  std::vector<float> mWide;  ///< Three for each of their voxels, per texel.
};

}  // namespace velum::render
