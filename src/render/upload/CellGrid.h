#pragma once
#include <glm/glm.hpp>
#include <vector>

namespace velum::render {

/// The grid of cells by which rays leap over empty space.
struct CellGrid {
  int edge = 4;        ///< Voxels along a cell's edge.
  glm::ivec3 size{0};  ///< Cells.
  bool operator==(const CellGrid&) const = default;
};
/// About 64 cells along the longest axis: fine enough to leap, few enough to rebuild while a transfer function is
/// dragged.
CellGrid cellGridFor(glm::ivec3 dims);

/// Smallest and largest texel of each cell with a halo of one voxel. Plain loops over native samples.
/// @param planes  [dims.z][dims.y][dims.x], from plane `firstPlane` on
template <class T>
std::vector<glm::vec2> computeCellRanges(const T* planes, glm::ivec3 dims, const CellGrid& cells, int firstCellZ,
                                         int lastCellZ, int firstPlane);

}  // namespace velum::render
