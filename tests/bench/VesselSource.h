#pragma once
#include <memory>

#include "core/Task.h"
#include "core/VoxelSource.h"

namespace velum::bench {

/// Two trees of vessels that fill an organ, as the phantom `vessels`, of any size: bricks are computed when they are
/// read, at each level by itself. 128 mm along each axis, 16 bits a voxel; vessels from 1150, tissue below 450.
/// @param size  voxels along each axis
std::unique_ptr<VoxelSource> makeVesselSource(int size, Progress& progress);

}  // namespace velum::bench
