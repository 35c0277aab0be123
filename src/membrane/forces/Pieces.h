#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/Task.h"

namespace velum::membrane {

/// Voxels that follow each other along x, from `x` to before `end`.
struct VoxelRun {
  std::uint32_t x = 0, end = 0;
  bool operator==(const VoxelRun&) const = default;
};

/// The pieces of protected voxels that are too small to count. A piece consists of voxels joined by faces.
struct SmallPieces {
  int least = 1;  ///< voxels that a piece must have to count; 1: all pieces count
  /// First run of each row (rows by y, then z), one more at the end; empty: there are no runs
  std::vector<std::uint32_t> first;
  std::vector<VoxelRun> runs;
  std::size_t pieces = 0, voxels = 0;  ///< how many small pieces there are, and the voxels in `runs`
  std::size_t protectedVoxels = 0;     ///< all protected voxels, those of small pieces included

  std::span<const VoxelRun> runsOf(std::size_t row) const {
    return first.empty() ? std::span<const VoxelRun>()
                         : std::span<const VoxelRun>(runs).subspan(first[row], first[row + 1] - first[row]);
  }
};

/// The least size, in voxels, of pieces that noise does not explain. Where pieces are noise, their number falls by
/// about the same factor from each size to the next; the result is the size of which less than one piece would be
/// expected. The result is 1, so that all pieces count, where pieces of one voxel are few, have a small share of all
/// voxels, or are not far more frequent than pieces of two: then they are structures, not noise.
/// @param counts  how many pieces there are of 1, 2, 3.. voxels; the first three counts are looked at
/// @param largest  voxels of the largest piece; the result is at most a tenth of that
/// @param all  voxels of all pieces
int leastPieceByNoise(std::span<const std::size_t> counts, std::size_t largest, std::size_t all);

/// Finds small pieces in a grid. All cores; 16 bytes for each run of protected voxels.
/// @param least  voxels that a piece must have to count; < 0: leastPieceByNoise()
/// @param row  writes which voxels of a row are protected: strengths [dims.x], above 0. Any thread
/// @throw Cancelled
SmallPieces findSmallPieces(glm::ivec3 dims, int least, const std::function<void(int y, int z, float* strengths)>& row,
                            const Progress& progress);

}  // namespace velum::membrane
