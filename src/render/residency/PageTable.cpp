#include "render/residency/PageTable.h"

#include <algorithm>

namespace velum::render {

namespace {

constexpr std::size_t kWord = sizeof(std::uint32_t);
constexpr std::size_t kRow = 4 * kWord;
constexpr std::size_t kMostChanges = 8192;  ///< that are told one by one

/// A slot's rows, as shaders read them.
struct PackedRows {
  glm::vec3 scale;
  float lastX;
  glm::vec3 first;
  float lastY;
  glm::ivec3 values;
  float lastZ;
  glm::ivec3 gradients;
  float lastZAgain;
};
static_assert(sizeof(PackedRows) == shared::kSlotRows * kRow);

}  // namespace

void PageTable::reset(const PageGrid& grid, int level, std::size_t slots) {
  mLevel = level;
  mSize = grid.levels()[std::size_t(level)].bricks;
  mSlots.assign(std::size_t(mSize.x) * std::size_t(mSize.y) * std::size_t(mSize.z), 0);
  mSlotCount = slots;
  mTexture = {};
  mBuffer = gpu::Buffer("pages", (firstRow() + (mSlots.size() + 3) / 4) * kRow);
  mTexture = gpu::Texture::makeOfBuffer("pages", gpu::Format::Rgba32ui, mBuffer);
  mFirstChanged = 0;
  mEndChanged = mSlots.size();
  mChanges.reset();
}

void PageTable::setRow(std::uint32_t slot, const SlotRow& row) {
  PackedRows rows{row.scale, row.last.x, row.first, row.last.y, row.values, row.last.z, row.gradients, row.last.z};
  mBuffer.write(std::size_t(slot) * sizeof(rows), sizeof(rows), &rows);
}

glm::ivec3 PageTable::pageAt(std::size_t index) const {
  auto x = std::size_t(mSize.x), y = std::size_t(mSize.y);
  return {int(index % x), int(index / x % y), int(index / (x * y))};
}

void PageTable::set(std::size_t index, std::uint32_t slot) {
  if (mSlots[index] == slot) return;
  mSlots[index] = slot;
  if (mChanges && mChanges->size() == kMostChanges) mChanges.reset();
  if (mChanges) mChanges->push_back(index);
  if (mFirstChanged == mEndChanged) mFirstChanged = index, mEndChanged = index + 1;
  mFirstChanged = std::min(mFirstChanged, index);
  mEndChanged = std::max(mEndChanged, index + 1);
}

PageTable::Pages PageTable::covered(const PageGrid& grid, const PageBrick& brick) const {
  if (brick.level < mLevel) return {};
  glm::ivec3 shift = grid.levels()[std::size_t(brick.level)].shift - grid.levels()[std::size_t(mLevel)].shift;
  Pages pages;
  for (int axis = 0; axis < 3; ++axis) {
    pages.low[axis] = std::min(brick.at[axis] << shift[axis], mSize[axis]);
    pages.high[axis] = std::min((brick.at[axis] + 1) << shift[axis], mSize[axis]);
    // The last brick stands for what lies a little beyond it, too.
    if (brick.at[axis] + 1 == grid.levels()[std::size_t(brick.level)].bricks[axis]) pages.high[axis] = mSize[axis];
  }
  return pages;
}

void PageTable::upload() {
  if (mFirstChanged == mEndChanged) return;
  mBuffer.write(firstRow() * kRow + mFirstChanged * kWord, (mEndChanged - mFirstChanged) * kWord,
                mSlots.data() + mFirstChanged);
  mFirstChanged = mEndChanged = 0;
}

}  // namespace velum::render
