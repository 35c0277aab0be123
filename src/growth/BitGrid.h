#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "growth/RowBits.h"

namespace velum::growth {

/// A bit for each voxel of a box, stored row by row (see RowBits.h).
class BitGrid {
 public:
  explicit BitGrid(glm::ivec3 dims)
      : mDims(dims), mWords(wordsOf(dims.x)), mBits(std::size_t(dims.y) * std::size_t(dims.z) * std::size_t(mWords)) {}

  glm::ivec3 dims() const { return mDims; }
  int words() const { return mWords; }
  bool holdsRow(int y, int z) const { return y >= 0 && z >= 0 && y < mDims.y && z < mDims.z; }
  Word* row(int y, int z) { return mBits.data() + place(y, z); }
  const Word* row(int y, int z) const { return mBits.data() + place(y, z); }
  /// Turns each bit to its opposite.
  void invert();

 private:
  std::size_t place(int y, int z) const {
    return (std::size_t(z) * std::size_t(mDims.y) + std::size_t(y)) * std::size_t(mWords);
  }

  glm::ivec3 mDims;
  int mWords;
  std::vector<Word> mBits;
};

/// Moves a row's bits towards higher x, or lower where `by` is negative; bits that leave the row are lost.
/// @param to  must not be the row `from`
void shiftRow(const Word* from, int fromWords, int by, Word* to, int toWords, int toWidth);

/// The part of a ball around a voxel that lies in one row, as offsets from that voxel: the row (y, z), and x from low
/// to high, both included.
struct BallRow {
  int y, z, low, high;
};
/// @param worldFromVoxel  the steps from voxel to voxel along the axes, in the world @param radius  world length;
/// voxels exactly this far away belong to the ball
std::vector<BallRow> ballRows(const glm::dmat3& worldFromVoxel, double radius);

/// A grid in which all voxels are set that lie in a ball around any voxel set in `grid`. All cores.
BitGrid dilated(const BitGrid& grid, const std::vector<BallRow>& ball);

/// The voxels of `open` that are joined by faces, through voxels of `open`, to voxels of `open` at the border of the
/// box.
BitGrid joinedToBorder(const BitGrid& open);

}  // namespace velum::growth
