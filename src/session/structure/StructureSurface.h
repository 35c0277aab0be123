#pragma once
#include <map>

#include "core/LabelVolume.h"
#include "core/Task.h"

namespace velum::session {

/// Areas of the surfaces of all structures that have voxels, by id, in square units of the world: found by counting how
/// many lines of 13 directions meet each surface [CROFTON]. Beyond the grid there is no structure, so that a surface is
/// closed at the grid's border. Exact on the mean over directions: a ball comes out within 1 %. A plane along the axes
/// comes out 7 % too small, the worst of all directions where voxels are cubes; up to a quarter where voxels are three
/// times as long as wide.
/// O(voxels of bricks at surfaces), all cores. @throw Cancelled. Any thread.
std::map<int, double> measureSurfaces(const LabelVolume& labels, Progress& progress);

}  // namespace velum::session
