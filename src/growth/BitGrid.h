#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "growth/RowBits.h"

namespace velum::growth {

/// A bit for each voxel of a box, in rows.
class BitGrid {
 public:
  explicit BitGrid(glm::ivec3 dims)
      : mDims(dims), mWords(wordsOf(dims.x)), mBits(std::size_t(dims.y) * std::size_t(dims.z) * std::size_t(mWords)) {}

  glm::ivec3 dims() const { return mDims; }
  int words() const { return mWords; }
  bool holdsRow(int y, int z) const { return y >= 0 && z >= 0 && y < mDims.y && z < mDims.z; }
  Word* row(int y, int z) { return mBits.data() + place(y, z); }
  const Word* row(int y, int z) const { return mBits.data() + place(y, z); }
  /// Each bit turned.
  void invert();

 private:
  std::size_t place(int y, int z) const {
    return (std::size_t(z) * std::size_t(mDims.y) + std::size_t(y)) * std::size_t(mWords);
  }

  glm::ivec3 mDims;
  int mWords;
  std::vector<Word> mBits;
};

/// Moves a row's bits towards higher x, or lower where `by` is negative; what leaves the row is lost.
/// @param to  not the same row
void shiftRow(const Word* from, int fromWords, int by, Word* to, int toWords, int toWidth);

/// Voxels of a ball around one voxel that lie in one row: offsets, from low to high, both included.
struct BallRow {
  int y, z, low, high;
};
/// @param worldFromVoxel  steps of the axes  @param radius  in the world; what lies at it is in
std::vector<BallRow> ballRows(const glm::dmat3& worldFromVoxel, double radius);

/// All voxels that lie in a ball around one that is set. All cores.
BitGrid dilated(const BitGrid& grid, const std::vector<BallRow>& ball);

/// What is joined by faces, through voxels of `open`, to those of it at the border of the box.
BitGrid joinedToBorder(const BitGrid& open);

}  // namespace velum::growth
