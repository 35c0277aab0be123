#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <vector>

#include "core/LabelVolume.h"
#include "render/upload/CellGrid.h"

namespace velum::render {

/// The grid of cells for which sets of labels are wanted: that of the volume, or that of the labels themselves.
struct LabelSpace {
  CellGrid cells;
  glm::ivec3 dims{1};            ///< Voxels of the cells' grid.
  glm::dmat4 worldFromTex{1.0};  ///< From texture coordinates 0..1 of that grid.
  bool operator==(const LabelSpace&) const = default;
};

/// Which labels each cell holds, as sets of ids mod 64 (bit 0: also where there are no labels). A set may hold ids that
/// the cell does not have, but never lacks one: it is the union of the sets of blocks of 8^3 label voxels.
class LabelCells {
 public:
  LabelCells(const LabelVolume& labels, const LabelSpace& over);
  /// Takes over changed bricks of labels that have the same grid and place. Looks only at these bricks and at the cells
  /// that touch them. @return true when the set of some cell has changed
  bool update(const LabelVolume& labels, std::span<const glm::ivec3> bricks);
  /// [cells.z][cells.y][cells.x]
  const std::vector<std::uint64_t>& sets() const { return mSets; }

 private:
  struct Box {
    glm::ivec3 low{0}, high{0};  ///< high: one past the last
  };
  Box collectBlocks(const LabelVolume& labels, glm::ivec3 brick);
  Box cellsTouching(const Box& blocks) const;
  bool recount(const std::vector<std::uint8_t>& isDirty);
  std::uint64_t setOf(glm::ivec3 cell) const;
  std::uint64_t block(glm::ivec3 at) const;

  LabelSpace mOver;
  glm::ivec3 mDims;          ///< Label voxels.
  glm::dmat4 mLabelFromVox;  ///< Label voxel indices from voxels of the cells' grid, whose corner is 0.
  glm::ivec3 mBlockGrid, mBrickGrid;
  static constexpr int kPerBrick = 4;  ///< blocks along an edge of a brick
  using Blocks = std::array<std::uint64_t, kPerBrick * kPerBrick * kPerBrick>;
  /// Of a brick: its set, where it is of one id; else those of its blocks.
  struct BrickSets {
    std::uint64_t all = 0;
    std::unique_ptr<Blocks> blocks;
  };
  std::vector<BrickSets> mBricks;
  std::vector<std::uint64_t> mSets;
};

}  // namespace velum::render
