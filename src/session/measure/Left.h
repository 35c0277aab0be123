#pragma once
#include <map>

#include "core/Task.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// What the cuts leave of a structure: volumes in cubed, areas in squared scene units.
struct StructureLeft {
  double whole = 0.0, left = 0.0;  ///< volume of all of it, and of what is left
  std::map<int, double> faces;     ///< area of the faces that cuts make in it, by the id of the cut
};

/// What the cuts leave of the structures of a scene, by id: each lies where pictures show it, between voxels, also
/// where it is hidden; sheets of membranes hang as their shapes in the scene say. Volumes and faces are counted at 32
/// places of each voxel that a border or a face passes; the places differ from voxel to voxel, so that planes along the
/// voxels count right, too. O(voxels of bricks that are not uniform), all cores. Empty where there are no labels.
/// @param only  the structure that is asked for; 0: all
/// @throw Cancelled. Any thread.
std::map<int, StructureLeft> measureLeft(const scene::Scene& scene, int only, Progress& progress);

}  // namespace velum::session
