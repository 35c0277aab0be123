#pragma once
#include <memory>

#include "core/Task.h"
#include "core/VoxelSource.h"

namespace velum::io {

/// A brain of a mouse with a few thousand of its nerve cells, as a light sheet sees it: of any size, for nothing of it
/// is in memory but the cells' tubes; bricks are computed when they are read, at each level by itself. Deterministic:
/// the same size gives the same voxels. Thirteen millimetres long, 16 bits a voxel.
/// @param size  voxels along the longest axis, 64..65536
/// @throw ArgumentError for another size; Cancelled
std::unique_ptr<VoxelSource> makeBrain(int size, Progress& progress);

}  // namespace velum::io
