#pragma once
#include <algorithm>
#include <vector>

#include "core/LabelVolume.h"
#include "growth/Admission.h"
#include "growth/RowBits.h"

namespace velum::growth {

constexpr int kLabelBrick = LabelVolume::kBrickSize;

/// True where a brick of labels has an id.
inline bool holdsLabel(const LabelVolume::Brick& brick, int id) {
  return std::any_of(brick.begin(), brick.end(), [&](std::uint16_t is) { return is == id; });
}

/// Calls body(y, z) for the rows of a brick, once for all bricks along a row.
template <class Body>
void forBrickRows(glm::ivec3 dims, int by, int bz, const Body& body) {
  for (int z = bz * kLabelBrick; z < std::min((bz + 1) * kLabelBrick, dims.z); ++z)
    for (int y = by * kLabelBrick; y < std::min((by + 1) * kLabelBrick, dims.y); ++y) body(y, z);
}

/// Calls body(y, z, bits) for each row in which a structure has voxels.
template <class Body>
void forRowsOf(const LabelVolume& labels, int structure, const Body& body) {
  glm::ivec3 grid = labels.brickGrid();
  std::vector<Word> bits(static_cast<std::size_t>(wordsOf(labels.dims().x)));
  for (int bz = 0; bz < grid.z; ++bz)
    for (int by = 0; by < grid.y; ++by) {
      bool isThere = false;
      for (int bx = 0; bx < grid.x; ++bx) isThere = isThere || holdsLabel(labels.brick({bx, by, bz}), structure);
      if (!isThere) continue;
      forBrickRows(labels.dims(), by, bz, [&](int y, int z) {
        labelBits(labels, y, z, std::uint16_t(structure), bits.data());
        if (std::any_of(bits.begin(), bits.end(), [](Word w) { return w != 0; })) body(y, z, bits);
      });
    }
}

}  // namespace velum::growth
