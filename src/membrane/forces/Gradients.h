#pragma once
#include <cstdint>
#include <vector>

#include "core/Task.h"
#include "core/Volume.h"

namespace velum::membrane {

/// Gradient magnitudes of one channel at one time step, in value per unit of length, as 16-bit codes, one a voxel. A
/// code is the square root of the magnitude's share of the largest one, so that weak gradients beside a few huge ones
/// keep their digits.
struct Gradients {
  std::vector<std::uint16_t> codes;  ///< [z][y][x]
  double largest = 0.0;              ///< value per unit of length
  double magnitude(int code) const { return largest * (code / 65535.0) * (code / 65535.0); }
};

/// Computes the gradients by central differences, one-sided at the volume's edges, transformed to the world by the
/// whole matrix, so that spacing and direction count. 0 where a neighbour is not a number. Two passes over the voxels,
/// all cores. @throw Cancelled
Gradients computeGradients(const Volume& volume, int channel, int timeStep, Progress& progress);

}  // namespace velum::membrane
