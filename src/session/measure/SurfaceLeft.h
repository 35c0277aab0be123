#pragma once
#include <glm/glm.hpp>

#include "core/Task.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// The part of a structure's own surface that the cuts leave, squared scene units; without the faces that they make. Of
/// its voxels, as the volume is: within 1 % of the truth where it is 20 voxels (by the longest edge) thick, 2 % at 12,
/// edges and corners with it. Costs as voxelFaces(). @param low, high  the box of its voxels, both ends included
/// @throw Cancelled. Any thread.
double surfaceLeft(const scene::Scene& scene, int structure, glm::ivec3 low, glm::ivec3 high, Progress& progress);

}  // namespace velum::session
