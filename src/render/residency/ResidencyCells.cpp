#include <algorithm>

#include "render/residency/Residency.h"

// What is known of the values in cells, by which rays leap.

namespace velum::render {

namespace {

constexpr float kAnyTexel = 1e30f;

}  // namespace

/// Of the coarse volume's texels in a box, box coordinates.
glm::vec2 Residency::coarseRange(glm::dvec3 low, glm::dvec3 high) const {
  const PageLevel& level = mGrid.levels().back();
  double edge = mCoarseCells.edge;
  glm::ivec3 last = mCoarseCells.size - 1;
  glm::ivec3 from = glm::clamp(glm::ivec3(glm::floor((low * level.voxelsPerBox + level.firstVoxel - 0.5) / edge)),
                               glm::ivec3(0), last);
  glm::ivec3 to =
      glm::clamp(glm::ivec3(glm::floor((high * level.voxelsPerBox + level.firstVoxel + 0.5) / edge)), from, last);
  glm::vec2 range(kAnyTexel, -kAnyTexel);
  for (int z = from.z; z <= to.z; ++z)
    for (int y = from.y; y <= to.y; ++y)
      for (int x = from.x; x <= to.x; ++x) {
        glm::vec2 cell = mCoarseRanges[(std::size_t(z) * std::size_t(mCoarseCells.size.y) + std::size_t(y)) *
                                           std::size_t(mCoarseCells.size.x) +
                                       std::size_t(x)];
        range = {std::min(range.x, cell.x), std::max(range.y, cell.y)};
      }
  return range;
}

glm::vec2 Residency::brickRange(const PageBrick& brick, const BrickRanges& ranges, glm::dvec3 low,
                                glm::dvec3 high) const {
  glm::dvec3 edge = mGrid.levels()[std::size_t(brick.level)].brickEdge;
  glm::dvec3 a = (low / edge - glm::dvec3(brick.at)) * double(kRangeCells),
             b = (high / edge - glm::dvec3(brick.at)) * double(kRangeCells);
  glm::ivec3 from = glm::clamp(glm::ivec3(glm::floor(a + 1e-6)), glm::ivec3(0), glm::ivec3(kRangeCells - 1));
  glm::ivec3 to = glm::clamp(glm::ivec3(glm::ceil(b - 1e-6)) - 1, from, glm::ivec3(kRangeCells - 1));
  glm::vec2 range(kAnyTexel, -kAnyTexel);
  for (int z = from.z; z <= to.z; ++z)
    for (int y = from.y; y <= to.y; ++y)
      for (int x = from.x; x <= to.x; ++x) {
        glm::vec2 cell = ranges.cells[std::size_t((z * kRangeCells + y) * kRangeCells + x)];
        range = {std::min(range.x, cell.x), std::max(range.y, cell.y)};
      }
  return range;
}

/// Of what is shown in a cell, and of what is wanted there: anything, where that was never read.
glm::vec2 Residency::cellRange(glm::ivec3 cell) const {
  const PageLevel& own = mGrid.levels()[std::size_t(mTable.level())];
  double edge = mVolume.cells.edge;
  glm::dvec3 low = (glm::dvec3(cell) * edge - own.firstVoxel) / own.voxelsPerBox;
  glm::dvec3 high = (glm::dvec3(cell + 1) * edge - own.firstVoxel) / own.voxelsPerBox;
  glm::ivec3 last = mTable.size() - 1;
  glm::ivec3 from = glm::clamp(glm::ivec3(glm::floor(low / own.brickEdge + 1e-9)), glm::ivec3(0), last);
  glm::ivec3 to = glm::clamp(glm::ivec3(glm::ceil(high / own.brickEdge - 1e-9)) - 1, from, last);
  glm::vec2 range(kAnyTexel, -kAnyTexel);
  auto add = [&](glm::vec2 more) { range = {std::min(range.x, more.x), std::max(range.y, more.y)}; };
  glm::ivec3 page;
  std::uint64_t before = ~std::uint64_t(0);
  bool addedCoarse = false;
  for (page.z = from.z; page.z <= to.z; ++page.z)
    for (page.y = from.y; page.y <= to.y; ++page.y)
      for (page.x = from.x; page.x <= to.x; ++page.x) {
        int wanted = wantedAt(page);
        std::uint32_t slot = mTable.slot(mTable.indexOf(page));
        if (slot == kEmptySlot) {
          add(glm::vec2(mEmptyTexel));
        } else if (slot == 0) {
          if (!addedCoarse) add(coarseRange(low, high));
          addedCoarse = true;
        } else {
          auto known = mKnown.find(mSlots[slot].brick.key());
          if (known == mKnown.end()) return {-kAnyTexel, kAnyTexel};
          add(brickRange(mSlots[slot].brick, known->second, low, high));
          if (mSlots[slot].brick.level == wanted) continue;
        }
        if (wanted == mGrid.coarsest()) continue;
        PageBrick brick = mGrid.parent({mTable.level(), page}, wanted);
        if (brick.key() == before) continue;
        before = brick.key();
        auto known = mKnown.find(before);
        if (known != mKnown.end())
          add(brickRange(brick, known->second, low, high));
        else if (!mFailed.contains(before))
          return {-kAnyTexel, kAnyTexel};
      }
  return range;
}

void Residency::updateCells() {
  const CellGrid& cells = mVolume.cells;
  mVolume.cellRanges.resize(std::size_t(cells.size.x) * std::size_t(cells.size.y) * std::size_t(cells.size.z));
  std::size_t i = 0;
  glm::ivec3 cell;
  for (cell.z = 0; cell.z < cells.size.z; ++cell.z)
    for (cell.y = 0; cell.y < cells.size.y; ++cell.y)
      for (cell.x = 0; cell.x < cells.size.x; ++cell.x) mVolume.cellRanges[i++] = cellRange(cell);
  mVolume.cellRange.write(0, mVolume.cellRanges.size() * sizeof(glm::vec2), mVolume.cellRanges.data());
  static std::uint64_t revisions = 0;  // of all volumes: one that is read anew is not taken for the one before
  mVolume.cellsRevision = ++revisions;
  mHasNews = false;
}

}  // namespace velum::render
