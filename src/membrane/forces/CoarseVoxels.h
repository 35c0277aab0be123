#pragma once
#include "core/Task.h"
#include "membrane/forces/Kernels.h"

namespace velum::membrane {

/// The protected voxels of the whole data on a coarse grid of blocks of voxels: a block is protected where a quarter of
/// its voxels is, so that thin structures stay in one piece. Block (0, 0, 0) begins with voxel (0, 0, 0); blocks at the
/// end may hold fewer voxels.
struct CoarseVoxels {
  glm::ivec3 step{1};    ///< voxels of a block along each axis
  ProtectedVoxels grid;  ///< of the blocks, whose middles are at integers
  glm::ivec3 dims{0};    ///< of the whole data
  /// The voxel in the middle of a block, or the last voxel of a block that holds fewer.
  glm::ivec3 voxelOf(glm::ivec3 block) const { return glm::min(block * step + step / 2, dims - 1); }
};

/// The field without its curve over gradients, for quick looks at the data: gradients take seconds the first time.
scene::ForceField withoutGradients(scene::ForceField field);

/// All cores; memory for one layer of blocks.
/// @param along  most blocks along an edge, where there are more voxels than that @throw Cancelled
CoarseVoxels coarseVoxels(const Potential& potential, const scene::ForceField& field, int along, Progress& progress);

}  // namespace velum::membrane
