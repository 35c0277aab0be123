#pragma once
#include "core/Task.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// The part of a structure's own surface that the cuts leave, squared scene units; without the faces that they make. 0
/// where the structure has no voxels. Seconds for millions of voxels. @throw Cancelled; InputError where the library is
/// missing that finds surfaces. Any thread.
double surfaceLeft(const scene::Scene& scene, int structure, Progress& progress);

}  // namespace velum::session
