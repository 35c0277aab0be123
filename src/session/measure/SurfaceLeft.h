#pragma once
#include <glm/glm.hpp>

#include "core/Task.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// The part of a structure's own surface that the cuts leave, squared scene units; without the faces that they make.
/// Seconds for millions of voxels. @param low, high  the box of its voxels, both ends included @throw Cancelled;
/// InputError where the library is missing that finds surfaces. Any thread.
double surfaceLeft(const scene::Scene& scene, int structure, glm::ivec3 low, glm::ivec3 high, Progress& progress);

}  // namespace velum::session
