#include "render/upload/SmoothTexels.h"

#include <algorithm>
#include <cmath>

#include "render/upload/Resample.h"

namespace velum::render {

glm::ivec3 smoothFactors(const Volume& volume) {
  constexpr double kMostFiner = 8.0;
  glm::dvec3 spacing = spacingOf(volume);
  double finest = std::min(spacing.x, std::min(spacing.y, spacing.z));
  glm::ivec3 finer(1);
  for (int axis = 0; axis < 3; ++axis)
    if (volume.dims[axis] > 1) finer[axis] = int(std::clamp(std::round(spacing[axis] / finest), 1.0, kMostFiner));
  if (finer == glm::ivec3(1)) finer = glm::min(volume.dims, glm::ivec3(2));
  return finer;
}

std::vector<float> smoothPlanes(const VolumeTexels& source, glm::ivec3 finer, int z0, int z1) {
  Span held = askedBy(splineTaps(finer.z, z0, z1), source.dims.z);
  std::vector<float> scratch;
  const float* values = source.planes<float>(held.low, held.high, scratch);
  return refine(values, 1, source.dims, held, finer, z0, z1, true);
}

}  // namespace velum::render
