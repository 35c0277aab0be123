#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <map>

#include "core/LabelVolume.h"
#include "core/Task.h"
#include "scene/Camera.h"

namespace velum::session {

/// How large a structure is, and where it lies.
struct StructureSize {
  std::uint64_t voxels = 0;
  double volume = 0;            ///< in thousands of cubic units of length: ml, or nm^3
  double surface = 0;           ///< in hundreds of square units of length: cm^2, or nm^2
  glm::dvec3 centroid{0.0};     ///< of the structure's voxels, voxel space; may lie outside of the structure
  glm::ivec3 low{0}, high{-1};  ///< the structure's box, voxels, both ends included
};

/// Sizes of all structures that have voxels, by id, without their surfaces. O(voxels of the bricks that are not
/// uniform).
/// @throw Cancelled. Any thread.
std::map<int, StructureSize> countStructures(const LabelVolume& labels, Progress& progress);
/// The same with their surfaces (see measureSurfaces()).
std::map<int, StructureSize> measureStructures(const LabelVolume& labels, Progress& progress);

/// The middle of the voxel of a structure that is nearest to the structure's centroid, world: a place inside it,
/// whatever its form.
/// @param size  as measured, with at least one voxel
glm::dvec3 middleOfStructure(const LabelVolume& labels, int structure, const StructureSize& size);

/// Radius of the ball about the structure's box, scene units.
double radiusOfStructure(const LabelVolume& labels, const StructureSize& size);

/// How much of a close-up's smaller side a ball fills, unless it is said.
inline constexpr double kCloseUpShare = 0.55;
/// The camera brought near to a ball, looking from the same side as before. @param aspect  width / height of the
/// picture  @param share  how much of its smaller side the ball fills
scene::Camera closeUp(scene::Camera camera, glm::dvec3 middle, double radius, double aspect,
                      double share = kCloseUpShare);

}  // namespace velum::session
