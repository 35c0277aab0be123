#pragma once
#include <algorithm>
#include <glm/glm.hpp>

#include "core/Volume.h"

namespace velum::session {

/// The value between the middles of voxels, linear; beyond the outermost ones these go on. NaN where a voxel about the
/// place is. Any thread.
/// @param voxel  indices in the volume
inline double valueBetween(const Volume& volume, glm::dvec3 voxel, int channel = 0, int timeStep = 0) {
  voxel = glm::clamp(voxel, glm::dvec3(0.0), glm::dvec3(volume.dims) - 1.0);
  glm::ivec3 base = glm::min(glm::ivec3(voxel), glm::max(volume.dims - 2, glm::ivec3(0)));
  glm::dvec3 f = voxel - glm::dvec3(base);
  double value = 0.0;
  for (int i = 0; i < 8; ++i) {
    glm::ivec3 corner(i & 1, i >> 1 & 1, i >> 2);
    glm::dvec3 w = glm::mix(1.0 - f, f, glm::dvec3(corner));
    double weight = w.x * w.y * w.z;
    if (weight > 0.0) value += weight * valueAt(volume, base + corner, channel, timeStep);
  }
  return value;
}

}  // namespace velum::session
