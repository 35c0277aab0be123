#pragma once
#include "core/Task.h"
#include "membrane/forces/Kernels.h"

namespace velum::membrane {

/// What a field protects of the whole data on a grid of blocks of voxels: a block counts where a quarter of it does, so
/// that what is thin stays in one piece. Block (0, 0, 0) begins with voxel (0, 0, 0); those at the end may hold fewer.
struct CoarseVoxels {
  glm::ivec3 step{1};    ///< voxels of a block along each axis
  ProtectedVoxels grid;  ///< of the blocks, whose middles are at integers
  glm::ivec3 dims{0};    ///< of the whole data
  /// The voxel in the middle of a block, or the last one of those that hold fewer.
  glm::ivec3 voxelOf(glm::ivec3 block) const { return glm::min(block * step + step / 2, dims - 1); }
};

/// For looks that are to be quick: gradients take seconds the first time.
scene::ForceField withoutGradients(scene::ForceField field);

/// All cores; memory for one layer of blocks.
/// @param along  blocks along an edge at most, where voxels are more  @throw Cancelled
CoarseVoxels coarseVoxels(const Potential& potential, const scene::ForceField& field, int along, Progress& progress);

}  // namespace velum::membrane
