#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <map>

#include "core/LabelVolume.h"
#include "core/Task.h"
#include "scene/Camera.h"

namespace velum::session {

/// How large a structure is and where.
struct StructureSize {
  std::uint64_t voxels = 0;
  double volume = 0;            ///< in thousands of cubic units of length: ml, or nm^3
  double surface = 0;           ///< in hundreds of square units of length: cm^2, or nm^2
  glm::dvec3 centroid{0.0};     ///< of its voxels, voxel space; may lie outside of it
  glm::ivec3 low{0}, high{-1};  ///< its box, voxels, both ends included
};

/// Sizes of all structures that have voxels, by id, but for their surfaces. O(voxels of the bricks that are not
/// uniform).
/// @throw Cancelled. Any thread.
std::map<int, StructureSize> countStructures(const LabelVolume& labels, Progress& progress);
/// The same with their surfaces (see measureSurfaces()). O(voxels).
std::map<int, StructureSize> measureStructures(const LabelVolume& labels, Progress& progress);

/// The voxel of a structure that is nearest to its centroid, world: a place inside it, whatever its form.
/// @param size  as measured, with at least one voxel
glm::dvec3 middleOfStructure(const LabelVolume& labels, int structure, const StructureSize& size);

/// Radius of the ball about the structure's box.
double radiusOfStructure(const LabelVolume& labels, const StructureSize& size);

/// The camera brought near to a ball, from the side on which it is. @param aspect  width / height of the picture
scene::Camera closeUp(scene::Camera camera, glm::dvec3 middle, double radius, double aspect);

}  // namespace velum::session
