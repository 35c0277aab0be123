#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/Task.h"

namespace velum::membrane {

/// Voxels that follow each other along x, without that at `end`.
struct VoxelRun {
  std::uint32_t x = 0, end = 0;
  bool operator==(const VoxelRun&) const = default;
};

/// The pieces of what is protected that are too small to count. A piece is what hangs together by voxels' faces.
struct SmallPieces {
  int least = 1;                     ///< voxels that a piece must have to count; 1: all do
  std::vector<std::uint32_t> first;  ///< of the runs of each row (y fastest, then z), and an end; empty: there are none
  std::vector<VoxelRun> runs;
  std::size_t pieces = 0, voxels = 0;  ///< in `runs`
  std::size_t protectedVoxels = 0;     ///< those among them

  std::span<const VoxelRun> runsOf(std::size_t row) const {
    return first.empty() ? std::span<const VoxelRun>()
                         : std::span<const VoxelRun>(runs).subspan(first[row], first[row + 1] - first[row]);
  }
};

/// The size from which on noise does not explain pieces. How many there are of one, two, three and so on voxels falls
/// by about the same factor from size to size where they are noise: the size is where that comes to less than one. 1,
/// so that all count, where pieces of one voxel are few, a small share of all voxels, or not far more than those of
/// two: structures, not noise.
/// @param counts  how many pieces there are of 1, 2, 3.. voxels; those of the first three are looked at
/// @param largest  voxels of the largest piece: the size is a tenth of it at most
/// @param all  voxels of all pieces
int leastPieceByNoise(std::span<const std::size_t> counts, std::size_t largest, std::size_t all);

/// Finds small pieces in a grid. All cores; 16 bytes for each run of protected voxels.
/// @param least  voxels that a piece must have to count; < 0: leastPieceByNoise()
/// @param row  writes which voxels of a row are protected: strengths [dims.x], above 0. Any thread
/// @throw Cancelled
SmallPieces findSmallPieces(glm::ivec3 dims, int least, const std::function<void(int y, int z, float* strengths)>& row,
                            const Progress& progress);

}  // namespace velum::membrane
