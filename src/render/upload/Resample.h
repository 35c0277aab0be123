#pragma once
#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

namespace velum::render {

/// What one number takes from a row of others along an axis, the first weight from number `first`.
struct Taps {
  int first = 0;
  std::vector<float> weights;
  float share = 0.0;  ///< Of splines: from the voxel before the place to the one after it.
};

/// From low to before high, along an axis.
struct Span {
  int low = 0, high = 0;
};

/// The numbers that taps ask for, of so many that there are.
Span askedBy(const std::vector<Taps>& taps, int whole);

/// The taps of texels from..to of which `finer` lie to a voxel: the cubic spline that goes through the voxels
/// ([THEVENAZ]).
std::vector<Taps> splineTaps(int finer, int from, int to);

/// A Gaussian around each of the voxels from..to. Zero: the voxel itself.
/// @param sigma  voxels, at most 5
std::vector<Taps> gaussianTaps(double sigma, int from, int to);

/// Rows smoothed along themselves.
/// @param perVoxel  numbers that lie side by side for each voxel
/// @param sigma     voxels, at most 5
std::vector<float> smoothRows(const float* numbers, int perVoxel, int width, int rows, double sigma);

/// A block of numbers, x fastest, of which those along one axis become what the taps make of them.
/// @param inner, outer  how many numbers lie side by side, and how many times the axis is met
/// @param held          what the block has along the axis, of `whole` that there are; what lies beyond the border is as
///                      the border
/// @param isLimited     of splines: beside an edge stay between the two neighbours, as a spline that swings over there
///                      would draw a shell of bone under the skin
std::vector<float> resample(const float* numbers, std::size_t inner, int outer, Span held, int whole,
                            const std::vector<Taps>& taps, bool isLimited = false);

/// Splines along all three axes, of planes of voxels of which only those held are there: texel planes z0..z1.
/// @param perVoxel  numbers that lie side by side for each voxel
/// @param finer     texels per voxel along each axis, 1 or more
std::vector<float> refine(const float* numbers, int perVoxel, glm::ivec3 dims, Span held, glm::ivec3 finer, int z0,
                          int z1, bool isLimited = false);

}  // namespace velum::render
