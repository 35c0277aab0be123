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

void labelBits(const LabelVolume& labels, int y, int z, std::uint16_t id, WordSpan words, Word* bits) {
  int bricks = labels.brickGrid().x, last = wordsOf(labels.dims().x) - 1;
  for (int w = words.first; w < words.end; ++w) {
    Word& word = bits[w - words.first];
    word = halfWord(labels, {2 * w, y / kBrick, z / kBrick}, y, z, id);
    if (2 * w + 1 < bricks) word |= halfWord(labels, {2 * w + 1, y / kBrick, z / kBrick}, y, z, id) << kBrick;
    if (w == last) word &= spanBits(last, 0, labels.dims().x);
  }
}

void labelBits(const LabelVolume& labels, int y, int z, std::uint16_t id, Word* bits) {
  labelBits(labels, y, z, id, {0, wordsOf(labels.dims().x)}, bits);
}

Admission::Admission(Shared<Volume> volume, const Shared<LabelVolume>& labels, GrowRule rule)
    : mVolume(std::move(volume)),
      mVoxels(*mVolume),
      mRule(std::move(rule)),
      mValues(grid(), mRule.low, mRule.high, mRule.channel, mRule.timeStep),
      mWorldFromSlope(glm::transpose(glm::inverse(glm::dmat3(grid().worldFromVoxel)))) {
  setLabels(labels);
  // A ball of a barrier's radius reaches as far along voxel indices as these rows are long.
  glm::dmat3 voxelFromWorld = glm::inverse(glm::dmat3(grid().worldFromVoxel));
  glm::dmat4 inverse = glm::inverse(grid().worldFromVoxel);
  for (const auto& barrier : mRule.barriers) {
    glm::dvec3 low(1e300), high(-1e300);
    for (const auto& point : barrier.path) {
      glm::dvec3 voxel(inverse * glm::dvec4(point, 1.0));
      low = glm::min(low, voxel), high = glm::max(high, voxel);
    }
    Box box;
    for (int i = 0; i < 3; ++i) {
      double reach = barrier.radius * glm::length(glm::row(voxelFromWorld, i)) + 0.5, end = grid().dims[i];
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
  if (isPiecewise()) return;
  for (int bz = 0; bz < grid.z; ++bz)
    for (int by = 0; by < grid.y; ++by) mFree.push_back(freeAlong(by, bz));
}

void Admission::keepFree(int y, int z, WordSpan words, Word* bits) const {
  if (!isPiecewise())
    switch (mFree[std::size_t(z / kBrick) * std::size_t(mLabels->brickGrid().y) + std::size_t(y / kBrick)]) {
      case Free::All:
        return;
      case Free::None:
        std::fill_n(bits, words.end - words.first, Word(0));
        return;
      case Free::Some:
        break;
    }
  for (int w = words.first; w < words.end; ++w) {
    Word& word = bits[w - words.first];
    if (word == 0) continue;
    Word free;
    labelBits(*mLabels, y, z, std::uint16_t(mRule.within), {w, w + 1}, &free);
    word &= free;
  }
}

/// The gradient's magnitude by central differences, one-sided at borders, value/length.
template <class ValueOf>
double Admission::slope(glm::ivec3 voxel, const ValueOf& valueOf) const {
  glm::dvec3 perVoxel(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    glm::ivec3 before = voxel, after = voxel;
    before[axis] = std::max(voxel[axis] - 1, 0);
    after[axis] = std::min(voxel[axis] + 1, grid().dims[axis] - 1);
    if (int steps = after[axis] - before[axis]; steps > 0) perVoxel[axis] = (valueOf(after) - valueOf(before)) / steps;
  }
  return glm::length(mWorldFromSlope * perVoxel);
}

void Admission::keepFlat(int y, int z, WordSpan words, Word* bits) const {
  for (int w = words.first; w < words.end; ++w) {
    Word& word = bits[w - words.first];
    auto keep = [&](const auto& valueOf) {
      for (Word left = word; left != 0; left &= left - 1) {
        int x = std::countr_zero(left);
        if (!(slope({w * kWordBits + x, y, z}, valueOf) < mRule.steepest)) clearBit(&word, x);
      }
    };
    if (word == 0) continue;
    if (!isPiecewise()) {
      keep([&](glm::ivec3 v) { return valueAt(grid(), v, mRule.channel, mRule.timeStep); });
      continue;
    }
    // With a voxel all around.
    glm::ivec3 low(w * kWordBits + std::countr_zero(word), y, z);
    glm::ivec3 high((w + 1) * kWordBits - std::countl_zero(word), y + 1, z + 1);
    glm::ivec3 first = glm::max(low - 1, glm::ivec3(0));
    Volume part = mVoxels.read(first, high + 1 - first, mRule.channel, mRule.timeStep);
    keep([&](glm::ivec3 v) { return valueAt(part, v - first); });
  }
}

void Admission::keepOutOfBarriers(int y, int z, WordSpan words, Word* bits) const {
  int start = words.first * kWordBits;
  for (std::size_t i = 0; i < mBarriers.size(); ++i) {
    const Box& box = mBarriers[i];
    if (y < box.first.y || y > box.last.y || z < box.first.z || z > box.last.z) continue;
    for (int x = std::max(box.first.x, start); x <= std::min(box.last.x, words.end * kWordBits - 1); ++x)
      if (bitAt(bits, x - start) &&
          holds(mRule.barriers[i], glm::dvec3(grid().worldFromVoxel * glm::dvec4(x, y, z, 1.0))))
        clearBit(bits, x - start);
  }
}

void Admission::open(int y, int z, WordSpan words, Word* bits) const {
  mValues.of(mVoxels, y, z, words, bits);
  keepFree(y, z, words, bits);
  if (mRule.steepest < std::numeric_limits<double>::infinity()) keepFlat(y, z, words, bits);
  keepOutOfBarriers(y, z, words, bits);
}

}  // namespace velum::growth
