#include "SkipMap.h"

#include <bit>

#include "velum/core/Assert.h"

namespace velum::render {

namespace {

using Rows = std::vector<std::uint64_t>;

/// Each row with those before and after it along an axis. @param stride  between them  @param count  along the axis
Rows withNeighbours(const Rows& rows, std::size_t stride, std::size_t count) {
  Rows out = rows;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::size_t at = i / stride % count;
    if (at > 0) out[i] |= rows[i - stride];
    if (at + 1 < count) out[i] |= rows[i + stride];
  }
  return out;
}

/// The set and the cells that touch it, at corners, too.
CellSet grown(CellSet set) {
  std::uint64_t whole = ~std::uint64_t(0) >> (64 - set.size.x);
  for (auto& row : set.rows) row = (row | row << 1 | row >> 1) & whole;
  auto ny = std::size_t(set.size.y);
  set.rows = withNeighbours(withNeighbours(set.rows, 1, ny), ny, std::size_t(set.size.z));
  return set;
}

void writeDistances(CellSet set, int channel, std::vector<glm::u8vec2>& map) {
  CellSet before(set.size);
  for (std::uint8_t distance = 0; distance < kFarthestLeap && set != before; ++distance) {
    for (std::size_t row = 0; row < set.rows.size(); ++row)
      for (std::uint64_t fresh = set.rows[row] & ~before.rows[row]; fresh != 0; fresh &= fresh - 1)
        map[row * std::size_t(set.size.x) + std::size_t(std::countr_zero(fresh))][channel] = distance;
    before = std::move(set);
    set = grown(before);
  }
}

}  // namespace

std::vector<glm::u8vec2> makeSkipMap(const CellSet& first, const CellSet& second) {
  VELUM_ASSERT(first.size == second.size && first.size.x >= 1 && first.size.x <= 64, "a row of cells is a word");
  std::vector<glm::u8vec2> map(first.rows.size() * std::size_t(first.size.x), glm::u8vec2(kFarthestLeap));
  writeDistances(first, 0, map);
  writeDistances(second, 1, map);
  return map;
}

}  // namespace velum::render
