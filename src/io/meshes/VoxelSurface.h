#pragma once
#include <cstdint>
#include <glm/glm.hpp>

#include "core/LabelVolume.h"
#include "core/Task.h"
#include "io/meshes/SurfaceShape.h"

namespace velum::io {

/// The surface of a structure's voxels, closed, with points midway between voxels in and out, and without normals. A
/// large box is worked on block by block, and only where the structure ends; where blocks meet they share their points,
/// so that there is no seam. Memory: two bytes for each voxel of the box, or of a block.
/// @param low, high       box that holds the structure's voxels, both ends included
/// @param mostAtOnce      voxels of a box that is worked on as a whole
/// @throw InputError when the structure has no voxel in the box; Cancelled
SurfaceShape voxelSurface(const LabelVolume& labels, std::uint16_t structure, glm::ivec3 low, glm::ivec3 high,
                          Progress& progress, double mostAtOnce = 256e6);

}  // namespace velum::io
