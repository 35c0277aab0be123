#pragma once
#include <glm/glm.hpp>
#include <limits>
#include <span>
#include <vector>

#include "core/Volume.h"
#include "scene/Growth.h"

namespace velum::growth {

/// Which voxels may join a region, wherever they lie.
struct GrowRule {
  double low = 0.0, high = 0.0;                               ///< values, the volume's unit, both ends included
  double steepest = std::numeric_limits<double>::infinity();  ///< their gradients are smaller than this, value/length
  int within = 0;                                             ///< label that they have before; 0: they have none
  int channel = 0, timeStep = 0;                              ///< of the volume
  std::vector<scene::Barrier> barriers;  ///< none of these strokes holds the middle of such a voxel
  bool operator==(const GrowRule&) const = default;
};
GrowRule ruleOf(const scene::Growth& growth);
/// @throw ArgumentError when a volume has no such channel or time step
void checkRule(const GrowRule& rule, const Volume& volume);

/// The voxel that holds a place of the world; may lie outside the volume.
glm::ivec3 voxelAt(const Volume& volume, glm::dvec3 world);
bool isInside(const Volume& volume, glm::ivec3 voxel);

/// True when a place lies within a stroke's radius of its path.
bool holds(const scene::Barrier& barrier, glm::dvec3 world);

}  // namespace velum::growth
