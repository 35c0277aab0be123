#pragma once
#include <string>

#include "core/Task.h"
#include "scene/SceneFwd.h"
#include "session/measure/MeshWay.h"

namespace velum::session {

struct SurfaceWay {
  MeshWay way;
  std::string problem;  ///< why there is none, one line for people
};

/// The shortest way between two places over the surface that is seen there: that of a surface from a file, of
/// structures, or where the volume has a value, see solidUnder(); faces of cuts belong to it, what cuts have removed is
/// no way. It is sought in a box about the places, which grows until no way that leaves it could be shorter. World
/// positions, scene units. A second for a box of 130^3 steps; longer ways are sought in coarser steps. Ways where a
/// value is are 0.2 % off the truth at most, over labels 1 % (3 % where voxels are four times as long as wide), and
/// short by half a voxel at each sharp edge of labels.
/// @throw Cancelled; InputError when a brick cannot be read. Any thread.
SurfaceWay wayOverSurface(const scene::Scene& scene, glm::dvec3 a, glm::dvec3 b, Progress& progress);

}  // namespace velum::session
