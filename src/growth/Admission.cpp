#include "growth/Admission.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/matrix_access.hpp>

namespace velum::growth {

namespace {

constexpr int kBrick = LabelVolume::kBrickSize;
static_assert(2 * kBrick == kWordBits, "a brick is half a word");

/// One brick's part of a row.
Word halfWord(const LabelVolume& labels, glm::ivec3 brick, int y, int z, std::uint16_t id) {
  const LabelVolume::Brick& ids = labels.brick(brick);
  if (ids.size() == 1) return ids[0] == id ? 0xffffffffu : 0;
  const std::uint16_t* row = ids.data() + (std::size_t(z % kBrick) * kBrick + std::size_t(y % kBrick)) * kBrick;
  alignas(16) std::uint8_t is[kWordBits] = {};
  for (int i = 0; i < kBrick; ++i) is[i] = row[i] == id;
  return packBytes(is);
}

}  // namespace

void labelBits(const LabelVolume& labels, int y, int z, std::uint16_t id, Word* bits) {
  int words = wordsOf(labels.dims().x), bricks = labels.brickGrid().x;
  for (int w = 0; w < words; ++w) {
    bits[w] = halfWord(labels, {2 * w, y / kBrick, z / kBrick}, y, z, id);
    if (2 * w + 1 < bricks) bits[w] |= halfWord(labels, {2 * w + 1, y / kBrick, z / kBrick}, y, z, id) << kBrick;
  }
  bits[words - 1] &= spanBits(words - 1, 0, labels.dims().x);
}

Admission::Admission(Shared<Volume> volume, const Shared<LabelVolume>& labels, GrowRule rule)
    : mVolume(std::move(volume)),
      mRule(std::move(rule)),
      mValues(*mVolume, mRule.low, mRule.high, mRule.channel, mRule.timeStep),
      mWorldFromSlope(glm::transpose(glm::inverse(glm::dmat3(mVolume->worldFromVoxel)))) {
  setLabels(labels);
  // A ball of a barrier's radius reaches as far along voxel indices as these rows are long.
  glm::dmat3 voxelFromWorld = glm::inverse(glm::dmat3(mVolume->worldFromVoxel));
  glm::dmat4 inverse = glm::inverse(mVolume->worldFromVoxel);
  for (const auto& barrier : mRule.barriers) {
    glm::dvec3 low(1e300), high(-1e300);
    for (const auto& point : barrier.path) {
      glm::dvec3 voxel(inverse * glm::dvec4(point, 1.0));
      low = glm::min(low, voxel), high = glm::max(high, voxel);
    }
    Box box;
    for (int i = 0; i < 3; ++i) {
      double reach = barrier.radius * glm::length(glm::row(voxelFromWorld, i)) + 0.5, end = mVolume->dims[i];
      box.first[i] = int(std::clamp(low[i] - reach, 0.0, end));
      box.last[i] = int(std::clamp(high[i] + reach, -1.0, end - 1.0));
    }
    mBarriers.push_back(box);
  }
}

Admission::Free Admission::freeAlong(int by, int bz) const {
  int free = 0, bricks = mLabels->brickGrid().x;
  for (int bx = 0; bx < bricks; ++bx) {
    const auto& ids = mLabels->brick({bx, by, bz});
    if (ids.size() > 1) return Free::Some;
    free += ids[0] == mRule.within;
  }
  return free == 0 ? Free::None : free == bricks ? Free::All : Free::Some;
}

void Admission::setLabels(const Shared<LabelVolume>& labels) {
  mLabels = labels;
  glm::ivec3 grid = labels->brickGrid();
  mFree.clear();
  for (int bz = 0; bz < grid.z; ++bz)
    for (int by = 0; by < grid.y; ++by) mFree.push_back(freeAlong(by, bz));
}

void Admission::keepFree(int y, int z, Word* bits) const {
  int words = wordsOf(mVolume->dims.x);
  switch (mFree[std::size_t(z / kBrick) * std::size_t(mLabels->brickGrid().y) + std::size_t(y / kBrick)]) {
    case Free::All:
      return;
    case Free::None:
      std::fill_n(bits, words, Word(0));
      return;
    case Free::Some:
      break;
  }
  std::vector<Word> free(static_cast<std::size_t>(words));
  labelBits(*mLabels, y, z, std::uint16_t(mRule.within), free.data());
  for (int w = 0; w < words; ++w) bits[w] &= free[std::size_t(w)];
}

void Admission::keepFlat(int y, int z, Word* bits) const {
  for (int x = 0; x < mVolume->dims.x; ++x)
    if (bitAt(bits, x) && !(gradientMagnitude(*mVolume, {x, y, z}, mRule.channel, mRule.timeStep) < mRule.steepest))
      clearBit(bits, x);
}

void Admission::keepOutOfBarriers(int y, int z, Word* bits) const {
  for (std::size_t i = 0; i < mBarriers.size(); ++i) {
    const Box& box = mBarriers[i];
    if (y < box.first.y || y > box.last.y || z < box.first.z || z > box.last.z) continue;
    for (int x = box.first.x; x <= box.last.x; ++x)
      if (bitAt(bits, x) && holds(mRule.barriers[i], glm::dvec3(mVolume->worldFromVoxel * glm::dvec4(x, y, z, 1.0))))
        clearBit(bits, x);
  }
}

void Admission::open(int y, int z, Word* bits) const {
  mValues.of(*mVolume, y, z, bits);
  keepFree(y, z, bits);
  if (mRule.steepest < std::numeric_limits<double>::infinity()) keepFlat(y, z, bits);
  keepOutOfBarriers(y, z, bits);
}

}  // namespace velum::growth
