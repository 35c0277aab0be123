#include "render/residency/PageTable.h"

#include <algorithm>

namespace velum::render {

namespace {

constexpr std::size_t kWord = sizeof(std::uint32_t);
static_assert(sizeof(SlotRow) == shared::kSlotWords * kWord);

}  // namespace

void PageTable::reset(const PageGrid& grid, int level, std::size_t slots) {
  mLevel = level;
  mSize = grid.levels()[std::size_t(level)].bricks;
  mSlots.assign(std::size_t(mSize.x) * std::size_t(mSize.y) * std::size_t(mSize.z), 0);
  mOwn.assign(slots, 0);
  mTexture = {};
  mBuffer = gpu::Buffer("pages", (firstWord() + mSlots.size()) * kWord);
  mTexture = gpu::Texture::makeOfBuffer("pages", gpu::Format::R32ui, mBuffer);
  mFirstChanged = 0;
  mEndChanged = mSlots.size();
}

void PageTable::setRow(std::uint32_t slot, const SlotRow& row, std::optional<glm::ivec3> place) {
  mBuffer.write(std::size_t(slot) * sizeof(row), sizeof(row), &row);
  mOwn[slot] = 0;
  // As bits hold it.
  if (place && place->x < 256 && place->y < 256 && place->z < 1024)
    mOwn[slot] =
        shared::kOwnBrick | std::uint32_t(place->x) | std::uint32_t(place->y) << 8 | std::uint32_t(place->z) << 16;
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
  std::vector<std::uint32_t> words;
  words.reserve(mEndChanged - mFirstChanged);
  for (std::size_t i = mFirstChanged; i < mEndChanged; ++i) {
    std::uint32_t slot = mSlots[i];
    words.push_back(mOwn[slot] ? mOwn[slot] : slot);
  }
  mBuffer.write((firstWord() + mFirstChanged) * kWord, words.size() * kWord, words.data());
  mFirstChanged = mEndChanged = 0;
}

}  // namespace velum::render
