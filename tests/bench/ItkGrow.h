#pragma once
#include <glm/glm.hpp>

#include "core/Volume.h"

namespace velum::bench {

/// What a filter took, and how many voxels it found.
struct Timing {
  double ms = 0.0;
  std::size_t voxels = 0;
};

/// itk::ConnectedThresholdImageFilter from a seed, the filter alone. 8 and 16 bit and float, first time step.
Timing growWithItk(const Volume& volume, glm::ivec3 seed, double low, double high);

}  // namespace velum::bench
