#pragma once
#include <cstdint>
#include <glm/glm.hpp>

#include "core/LabelCover.h"
#include "core/Mesh.h"
#include "core/Task.h"

namespace velum::io {

/// The surface of a structure, where pictures, sections and counts have its border: between voxels, as
/// StructureField::at() says. Closed, also where it meets the data's border, half a voxel beyond the outermost voxels;
/// each edge in two triangles, normals outwards. In the world of the labels, without name and colour. Besides the
/// mesh it needs two bytes a voxel of the box while it works, and what the field keeps.
/// @param low, high  box that holds the structure's voxels, both ends included
/// @param smoothness  0: as pictures show it; more is rounded off further, up to 1, and encloses as much
/// @throw InputError when the structure has no voxel in the box; Cancelled. Any thread.
Mesh extractSurface(const StructureField& field, std::uint16_t structure, glm::ivec3 low, glm::ivec3 high,
                    double smoothness, Progress& progress);

}  // namespace velum::io
