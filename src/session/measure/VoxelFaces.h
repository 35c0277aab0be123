#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/LabelVolume.h"
#include "core/Task.h"

namespace velum::session {

/// A face between a voxel of a structure and one that is not of it.
struct VoxelFace {
  glm::ivec3 voxel{0};
  glm::ivec3 way{0};  ///< to the voxel beyond it: one of the six
  double area = 0.0;  ///< how much of the structure's surface it stands for, squared scene units
};

/// All faces of a structure's voxels, also where the grid ends, each with its share of the surface: as much as is seen
/// of it along the surface's normal, which is the mean of the faces around. Steps between voxels add nothing then, and
/// plane and round surfaces come out right. Edges are rounded off by such means, the wider the more, so that two widths
/// tell what none would give: edges stay. A face may stand for less than nothing; sums are right.
///
/// The widths, 3 and 6 voxels (by the longest edge) where the structure is thick, are less where it is thin. Tuned on
/// half of the phantoms of docs/PERFORMANCE.md, Measures. O(voxels of the box's bricks that are not uniform + 100
/// faces), up to 300 bytes a face while it works, all cores.
/// @param low, high  box that holds the structure's voxels, both ends included
/// @throw Cancelled. Any thread.
std::vector<VoxelFace> voxelFaces(const LabelVolume& labels, std::uint16_t structure, glm::ivec3 low, glm::ivec3 high,
                                  Progress& progress);

}  // namespace velum::session
