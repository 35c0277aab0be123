#pragma once
#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

namespace velum::io {

/// A level of a pyramid that is to be written. Sizes are in its own voxels, along x, y, z.
struct PlannedLevel {
  glm::ivec3 dims{0};
  glm::ivec3 factor{1};       ///< voxels of the level before that one of its voxels stands for: 1 or 2 along each axis
  glm::ivec3 brick{1};        ///< what is packed, and read, at once
  glm::ivec3 shard{1};        ///< what a file holds: whole bricks
  glm::dvec3 scale{1.0};      ///< its voxels, in voxels of the finest level
  glm::dvec3 firstCentre{0};  ///< where the centre of its first voxel lies, in voxels of the finest level
};

/// How many voxels of the finest level one of a coarser level stands for along an axis, by how many there are in each:
/// a whole number where the coarser one can be of blocks of so many, the last of them cut or left out.
double blockFactor(double finest, double coarser);

/// The levels for a volume, the finest first. The axes that are halved are those whose voxels are within a factor of
/// sqrt(2) of the shortest edge, so that voxels become cubes and stay so; the last level has at most 128 voxels along
/// each axis. Sizes are rounded up.
///
/// A brick has about 64^3 voxels. A shard is one brick deep, so that it is whole after 64 planes of the source, and as
/// wide as makes some ten megabytes: 512 x 512 x 64 of 16 bits are 32 MiB, so that a terabyte is some ten thousands of
/// files, a core packs one in a tenth of a second to a second, that much is lost when the writer is killed, and as many
/// as there are cores fit into memory.
/// @param edge         of a brick, in voxels, where the volume is as large in all directions
/// @param sampleBytes  of one sample
std::vector<PlannedLevel> planPyramid(glm::ivec3 dims, glm::dvec3 spacing, int edge, std::size_t sampleBytes);

}  // namespace velum::io
