#pragma once
#include <glm/glm.hpp>

#include "growth/BitGrid.h"
#include "growth/RegionGrow.h"

namespace velum::growth {

/// A bit for each voxel of a box of a grid that may be far larger. Along x the box begins with a whole word, so that
/// its words are those of the grid's rows.
class BoxBits {
 public:
  explicit BoxBits(VoxelBox box)
      : mFirst(box.first.x / kWordBits * kWordBits, box.first.y, box.first.z), mBits(box.end - mFirst) {}

  /// The box's first voxel; voxels of bits() count from there.
  glm::ivec3 first() const { return mFirst; }
  glm::ivec3 end() const { return mFirst + mBits.dims(); }
  BitGrid& bits() { return mBits; }
  const BitGrid& bits() const { return mBits; }
  int firstWord() const { return mFirst.x / kWordBits; }

  /// Word of a row of the grid; 0 outside the box.
  Word word(int y, int z, int w) const {
    int in = w - firstWord();
    if (!mBits.holdsRow(y - mFirst.y, z - mFirst.z) || in < 0 || in >= mBits.words()) return 0;
    return mBits.row(y - mFirst.y, z - mFirst.z)[in];
  }
  /// @param voxel  of the grid, in the box
  void set(glm::ivec3 voxel) {
    glm::ivec3 in = voxel - mFirst;
    setBit(mBits.row(in.y, in.z), in.x);
  }

 private:
  glm::ivec3 mFirst;
  BitGrid mBits;
};

}  // namespace velum::growth
