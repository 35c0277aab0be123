#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "scene/SceneFwd.h"

namespace velum::scene {

/// Opacity of a unit of distance up to which material is a veil, through which one looks at what is behind.
inline constexpr double kVeil = 0.08;

/// Which voxels of a scene's volume show, or of its labels where these are alone: every so manieth along each axis.
struct ShownVoxels {
  glm::ivec3 dims{0};
  glm::dmat4 worldFromVoxel{1.0};
  std::vector<std::uint8_t> shown;  ///< 1 or 0, [z][y][x]
};

/// As colours and opacities, or the mode, show them; hidden structures do not; cuts do not matter. Any thread.
/// @param mostSamples  about so many voxels are looked at
/// @param veil  opacity up to which nothing shows
ShownVoxels shownVoxels(const Scene& scene, double mostSamples, double veil);

}  // namespace velum::scene
