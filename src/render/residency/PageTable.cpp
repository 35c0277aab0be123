#include "render/residency/PageTable.h"

#include <algorithm>
#include <span>

namespace velum::render {

void PageTable::reset(const PageGrid& grid, int level) {
  mLevel = level;
  mSize = grid.levels()[std::size_t(level)].bricks;
  mSlots.assign(std::size_t(mSize.x) * std::size_t(mSize.y) * std::size_t(mSize.z), 0);
  mTexture = {};
  mBuffer = gpu::Buffer("pages", std::span<const std::uint32_t>(mSlots));
  mTexture = gpu::Texture::makeOfBuffer("pages", gpu::Format::R32ui, mBuffer);
  mFirstChanged = mEndChanged = 0;
}

glm::ivec3 PageTable::pageAt(std::size_t index) const {
  auto x = std::size_t(mSize.x), y = std::size_t(mSize.y);
  return {int(index % x), int(index / x % y), int(index / (x * y))};
}

void PageTable::set(std::size_t index, std::uint32_t slot) {
  if (mSlots[index] == slot) return;
  mSlots[index] = slot;
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
  constexpr std::size_t kWord = sizeof(std::uint32_t);
  mBuffer.write(mFirstChanged * kWord, (mEndChanged - mFirstChanged) * kWord, mSlots.data() + mFirstChanged);
  mFirstChanged = mEndChanged = 0;
}

}  // namespace velum::render
