#pragma once
#include <string>
#include <vector>

#include "io/stores/ArraySource.h"

/// Where the levels of a pyramid lie that says it by a voxel size, or a matrix, and factors.
namespace velum::io {

/// How a level's voxels lie in those of the finest: a voxel stands for `factor` of them, and the first one's centre is
/// that of the first ones it stands for. @param factor  along x, y, z, not smaller than 1
glm::dmat4 finestFromLevel(glm::dvec3 factor);

/// How many voxels of the finest level one of another stands for, from their dims: whole numbers where rounding either
/// way explains them.
glm::dvec3 factorFromDims(glm::ivec3 finest, glm::ivec3 level);

/// Places all levels, and the head as the finest, and notes what is not known.
/// @param places  one a level: place of a voxel in the file's unit
/// @param unit    of lengths, as UDUNITS or microscopes call it; empty: unknown
void placeLevels(ArrayPyramid& pyramid, const std::vector<glm::dmat4>& places, const std::string& unit);

}  // namespace velum::io
