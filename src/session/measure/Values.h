#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "core/Task.h"
#include "scene/SceneFwd.h"
#include "session/measure/Profile.h"
#include "session/structure/StructureValues.h"

/// Values of a scene's volume, of its finest level, in the time step and channel that are shown. The scene must have a
/// volume. Voxels are read in cubes of 64, on all cores, so that of a streamed volume only what lies around the asked
/// places is read, and never much at a time. World positions are in the scene's unit. Any thread. All throw Cancelled,
/// and InputError where a brick cannot be read.
namespace velum::session {

/// Of the voxels whose middles lie in a ball, or in a circle, one voxel thick; where there are none, of the voxel in
/// which its middle lies. No voxels where that is outside of the volume. @param normal  of the circle, any length; 0: a
/// ball
StructureValues valuesInBall(const scene::Scene& scene, glm::dvec3 middle, double radius, glm::dvec3 normal,
                             Progress& progress);

/// Of the voxels whose middles lie in a box along the volume's axes with two opposite corners; along an axis along
/// which there are none, of the layer of voxels that is nearest to its middle.
StructureValues valuesInBox(const scene::Scene& scene, glm::dvec3 a, glm::dvec3 b, Progress& progress);

/// Of the voxels whose middles lie in a structure and are left by the cuts. The scene must have labels.
/// @param low, high  the box of the structure's voxels among the labels, both ends included
StructureValues valuesLeft(const scene::Scene& scene, int structure, glm::ivec3 low, glm::ivec3 high,
                           Progress& progress);

/// Along a line: half the smallest edge of a voxel apart, or further where these were more than 20,000; linear between
/// the middles of voxels. The first sample lies on `a`, the last on `b`.
std::vector<ProfileSample> profileAlong(const scene::Scene& scene, glm::dvec3 a, glm::dvec3 b, Progress& progress);

}  // namespace velum::session
