#include "render/upload/LabelCells.h"

#include <algorithm>
#include <atomic>

#include "core/Parallel.h"
#include "render/upload/gridIndex.h"

namespace velum::render {

namespace {

constexpr int kEdge = 8;  // label voxels along a block's edge

glm::dmat3 absolute(glm::dmat3 m) {
  for (int i = 0; i < 3; ++i) m[i] = glm::abs(m[i]);
  return m;
}

/// The ids (mod 64) of one block of a brick, as far as it lies in the grid.
/// @param inner  of the block in its brick  @param voxels  of the block that lie in the grid
std::uint64_t setOfBlock(const LabelVolume::Brick& brick, glm::ivec3 inner, glm::ivec3 voxels) {
  constexpr std::size_t kSize = LabelVolume::kBrickSize;
  std::uint64_t set = 0;
  glm::ivec3 corner = inner * kEdge;
  for (int z = 0; z < voxels.z; ++z)
    for (int y = 0; y < voxels.y; ++y) {
      const auto* row =
          &brick[(std::size_t(corner.z + z) * kSize + std::size_t(corner.y + y)) * kSize + std::size_t(corner.x)];
      for (int x = 0; x < voxels.x; ++x) set |= std::uint64_t(1) << (row[x] % 64);
    }
  return set;
}

}  // namespace

LabelCells::LabelCells(const LabelVolume& labels, const LabelSpace& over)
    : mOver(over), mDims(labels.dims()), mBlockGrid((mDims + kEdge - 1) / kEdge), mBrickGrid(labels.brickGrid()) {
  static_assert(kPerBrick * kEdge == LabelVolume::kBrickSize);
  glm::dmat4 texFromVox(1.0);
  for (int axis = 0; axis < 3; ++axis) texFromVox[axis][axis] = 1.0 / over.dims[axis];
  mLabelFromVox = glm::inverse(labels.worldFromVoxel()) * over.worldFromTex * texFromVox;
  mBricks.resize(countOf(mBrickGrid));
  mSets.assign(countOf(over.cells.size), 0);
  glm::ivec3 grid = labels.brickGrid();
  parallelFor(0, grid.x * grid.y * grid.z, [&](int job) {
    collectBlocks(labels, {job % grid.x, job / grid.x % grid.y, job / (grid.x * grid.y)});
  });
  recount(std::vector<std::uint8_t>(mSets.size(), 1));
}

std::uint64_t LabelCells::block(glm::ivec3 at) const {
  const BrickSets& brick = mBricks[indexIn(mBrickGrid, at / kPerBrick)];
  return brick.blocks ? (*brick.blocks)[indexIn(glm::ivec3(kPerBrick), at % kPerBrick)] : brick.all;
}

/// Counts the blocks of a brick anew. @return a box around those whose sets are others now; empty when there are none
LabelCells::Box LabelCells::collectBlocks(const LabelVolume& labels, glm::ivec3 index) {
  Box changed{mBlockGrid, glm::ivec3(0)};
  const auto& ids = labels.brick(index);
  BrickSets now;
  if (ids.size() == 1)
    now.all = std::uint64_t(1) << (ids[0] % 64);
  else
    now.blocks = std::make_unique<Blocks>();
  for (int i = 0; i < int(Blocks().size()); ++i) {
    glm::ivec3 inner = cellIn(glm::ivec3(kPerBrick), std::size_t(i)), at = index * kPerBrick + inner;
    if (glm::any(glm::greaterThanEqual(at, mBlockGrid))) continue;
    std::uint64_t set = now.all;
    if (now.blocks)
      set = (*now.blocks)[std::size_t(i)] = setOfBlock(ids, inner, glm::min(mDims - at * kEdge, glm::ivec3(kEdge)));
    if (set == block(at)) continue;
    changed.low = glm::min(changed.low, at);
    changed.high = glm::max(changed.high, at + 1);
  }
  mBricks[indexIn(mBrickGrid, index)] = std::move(now);
  return changed;
}

/// The cells whose sets may hold one of some blocks: those for which setOf() looks at it, and a few around them.
LabelCells::Box LabelCells::cellsTouching(const Box& blocks) const {
  // A cell's box among the labels is as long as the sums of its edges there. It touches the blocks where its middle is
  // nearer to theirs than both halves together.
  glm::dmat3 m(mLabelFromVox), back = glm::inverse(m);
  double edge = mOver.cells.edge;
  glm::dvec3 cellHalf = absolute(m) * glm::dvec3(edge * 0.5 + 1.0);
  glm::dvec3 low = glm::dvec3(blocks.low * kEdge) - 2.0, high = glm::dvec3(blocks.high * kEdge) + 1.0;
  glm::dvec3 middle = back * ((low + high) * 0.5 - glm::dvec3(mLabelFromVox[3]));
  glm::dvec3 half = absolute(back) * (cellHalf + (high - low) * 0.5) + 1e-6 * edge;
  auto cellAt = [&](glm::dvec3 vox) {
    return glm::ivec3(glm::clamp(glm::floor(vox / edge - 0.5), glm::dvec3(-1.0), glm::dvec3(mOver.cells.size)));
  };
  return {glm::max(cellAt(middle - half), glm::ivec3(0)), glm::min(cellAt(middle + half) + 2, mOver.cells.size)};
}

/// The union of the blocks that a cell's box (with the halo of a voxel) touches in the labels' grid.
std::uint64_t LabelCells::setOf(glm::ivec3 cell) const {
  glm::dvec3 low(1e30), high(-1e30);
  for (int corner = 0; corner < 8; ++corner) {
    glm::dvec3 step(corner & 1, corner >> 1 & 1, corner >> 2);
    glm::dvec3 p(mLabelFromVox *
                 glm::dvec4((glm::dvec3(cell) + step) * double(mOver.cells.edge) + (step * 2.0 - 1.0), 1.0));
    low = glm::min(low, p), high = glm::max(high, p);
  }
  std::uint64_t set = 0;
  glm::dvec3 last = glm::dvec3(mDims) - 1.0;
  bool leaves = glm::any(glm::lessThan(low, glm::dvec3(-0.5))) || glm::any(glm::greaterThan(high, last + 0.5));
  if (leaves) set |= 1;  // outside the labels there is no structure: id 0
  bool isOutside = glm::any(glm::lessThan(high, glm::dvec3(-1.0))) || glm::any(glm::greaterThan(low, last + 1.0));
  if (!isOutside) {
    glm::ivec3 b0 = glm::ivec3(glm::floor(glm::clamp(low - 1.0, glm::dvec3(0.0), last))) / kEdge;
    glm::ivec3 b1 = glm::ivec3(glm::ceil(glm::clamp(high + 1.0, glm::dvec3(0.0), last))) / kEdge;
    for (int z = b0.z; z <= b1.z; ++z)
      for (int y = b0.y; y <= b1.y; ++y)
        for (int x = b0.x; x <= b1.x; ++x) set |= block({x, y, z});
  }
  return set;
}

/// Puts together the sets of some cells. @param isDirty  which, in the order of the sets
/// @return true when one is another now
bool LabelCells::recount(const std::vector<std::uint8_t>& isDirty) {
  glm::ivec3 size = mOver.cells.size;
  std::atomic<bool> hasChanged = false;
  parallelFor(0, size.y * size.z, [&](int row) {
    for (int x = 0; x < size.x; ++x) {
      glm::ivec3 cell(x, row % size.y, row / size.y);
      std::size_t i = indexIn(size, cell);
      if (!isDirty[i]) continue;
      std::uint64_t set = setOf(cell);
      if (set == mSets[i]) continue;
      mSets[i] = set;
      hasChanged = true;
    }
  });
  return hasChanged;
}

bool LabelCells::update(const LabelVolume& labels, std::span<const glm::ivec3> bricks) {
  std::vector<Box> changed(bricks.size());
  parallelFor(std::size_t(0), bricks.size(), [&](std::size_t i) { changed[i] = collectBlocks(labels, bricks[i]); });
  std::vector<std::uint8_t> isDirty(mSets.size(), 0);
  bool any = false;
  for (const Box& blocks : changed) {
    if (blocks.high.x == 0) continue;
    any = true;
    Box cells = cellsTouching(blocks);
    for (int z = cells.low.z; z < cells.high.z; ++z)
      for (int y = cells.low.y; y < cells.high.y; ++y)
        for (int x = cells.low.x; x < cells.high.x; ++x) isDirty[indexIn(mOver.cells.size, {x, y, z})] = 1;
  }
  return any && recount(isDirty);
}

}  // namespace velum::render
