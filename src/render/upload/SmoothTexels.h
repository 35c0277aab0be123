#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "render/upload/VolumeTexels.h"

namespace velum::render {

/// Texels per voxel along each axis that let linear interpolation between them pass for cubic interpolation between
/// voxels: as many as make a coarse axis as fine as the finest one; two along each where none is coarse. At most eight.
glm::ivec3 smoothFactors(const Volume& volume);

/// Planes z0..z1 of a volume with more texels than voxels: the cubic spline through the voxels ([THEVENAZ]),
/// beyond the border of which a voxel repeats.
/// Differs: beside an edge a value stays between the two voxels around it along an axis, as a spline that swings over
///          there would draw a shell of bone under the skin.
/// @param source  of level 1; its values, not colours
/// @param finer   texels per voxel along each axis, 1 or more
std::vector<float> smoothPlanes(const VolumeTexels& source, glm::ivec3 finer, int z0, int z1);

}  // namespace velum::render
