#pragma once
#include <cstdint>
#include <glm/glm.hpp>

#include "core/LabelCover.h"
#include "core/Mesh.h"
#include "core/Task.h"

namespace velum::io {

/// The surface of a structure at the same border that pictures, sections and counts show: between voxels, as
/// StructureField::at() says. The surface is closed, also where it meets the data's border, half a voxel beyond the
/// outermost voxels; each edge belongs to two triangles, and normals point outwards. In the world of the labels,
/// without name and colour. Memory besides the mesh: two bytes for each voxel of the box while it works, and the covers
/// that the field keeps.
/// @param low, high  box that holds the structure's voxels, both ends included
/// @param smoothness  0: the surface as pictures show it; larger values, up to 1, round it off further but keep the
/// volume that it encloses
/// @throw InputError when the structure has no voxel in the box; Cancelled. Any thread.
Mesh extractSurface(const StructureField& field, std::uint16_t structure, glm::ivec3 low, glm::ivec3 high,
                    double smoothness, Progress& progress);

}  // namespace velum::io
