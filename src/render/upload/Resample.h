#pragma once
#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

namespace velum::render {

/// The weights by which one result is made from numbers along an axis; the first weight belongs to number `first`.
struct Taps {
  int first = 0;
  std::vector<float> weights;
  float share = 0.0;  ///< For splines: the place of the result, as a share of the way from the voxel before it to the
                      ///< voxel after it.
};

/// The numbers from low to before high along an axis.
struct Span {
  int low = 0, high = 0;
};

/// The range of numbers that taps need, of `whole` numbers along the axis.
Span askedBy(const std::vector<Taps>& taps, int whole);

/// The taps of texels from..to, with `finer` texels for each voxel: the cubic spline that goes through the voxels
/// ([THEVENAZ]).
std::vector<Taps> splineTaps(int finer, int from, int to);

/// The taps of a Gaussian around each of the voxels from..to. With sigma 0: the voxel itself.
/// @param sigma  voxels, at most 5
std::vector<Taps> gaussianTaps(double sigma, int from, int to);

/// Rows of numbers, smoothed along their length.
/// @param perVoxel  numbers that lie side by side for each voxel
/// @param sigma  voxels, at most 5
std::vector<float> smoothRows(const float* numbers, int perVoxel, int width, int rows, double sigma);

/// A block of numbers, x fastest, in which the numbers along one axis are replaced by those that the taps make of them.
/// @param inner, outer  how many numbers lie side by side at each step of the axis, and how many times the axis is
/// repeated
/// @param held  the numbers that the block has along the axis, of `whole` that exist; beyond the border the outermost
/// number repeats
/// @param isLimited  for splines: results stay between the two neighbouring numbers beside an edge, as a spline that
/// overshoots there would draw a shell of bone under the skin
std::vector<float> resample(const float* numbers, std::size_t inner, int outer, Span held, int whole,
                            const std::vector<Taps>& taps, bool isLimited = false);

/// Texel planes z0..z1, made by splines along all three axes from the planes of voxels that are held.
/// @param perVoxel  numbers that lie side by side for each voxel
/// @param finer  texels per voxel along each axis, 1 or more
std::vector<float> refine(const float* numbers, int perVoxel, glm::ivec3 dims, Span held, glm::ivec3 finer, int z0,
                          int z1, bool isLimited = false);

}  // namespace velum::render
