#pragma once
#include <cstdint>
#include <glm/glm.hpp>

#include "velum/core/LabelVolume.h"
#include "velum/core/Mesh.h"
#include "velum/core/Task.h"

namespace velum::io {

/// The surface of a structure: closed, also where it meets the data's border, each edge in two triangles, normals
/// outwards; it encloses as much as the voxels have. In the world of the labels, with name and colour of their table.
/// @param low, high  box that holds the structure's voxels, both ends included
/// @param smoothness  0: midway between voxels in and out, with steps; 1: very round
/// @throw InputError when the structure has no voxel in the box; Cancelled. Any thread.
Mesh extractSurface(const LabelVolume& labels, std::uint16_t structure, glm::ivec3 low, glm::ivec3 high,
                    double smoothness, Progress& progress);

}  // namespace velum::io
