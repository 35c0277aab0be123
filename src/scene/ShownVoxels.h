#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "scene/SceneFwd.h"

namespace velum::scene {

/// Material whose opacity for a unit of distance is at most this is a veil, through which one sees what lies behind.
inline constexpr double kVeil = 0.08;

/// Which voxels of a scene's volume show, or of its labels where these are alone: every so manieth along each axis.
struct ShownVoxels {
  glm::ivec3 dims{0};
  glm::dmat4 worldFromVoxel{1.0};
  std::vector<std::uint8_t> shown;  ///< 1 or 0, [z][y][x]
};

/// Finds the voxels that the colours and opacities, or the mode, show. Hidden structures do not count as shown; cuts
/// are ignored. Any thread.
/// @param mostSamples  about so many voxels are looked at
/// @param veil  opacity up to which nothing shows
ShownVoxels shownVoxels(const Scene& scene, double mostSamples, double veil);

}  // namespace velum::scene
