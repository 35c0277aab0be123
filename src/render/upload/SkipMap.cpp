#include "render/upload/SkipMap.h"

#include <bit>

#include "core/Assert.h"
#include "core/Parallel.h"

namespace velum::render {

namespace {

/// Adds to each row the one after it or before it. In place: what is added has not been changed yet.
/// @param stride  between them  @param count  of rows that have one
void addNeighbours(std::uint64_t* rows, std::size_t stride, std::size_t count, bool isAfter) {
  if (isAfter)
    for (std::size_t i = 0; i < count; ++i) rows[i] |= rows[i + stride];
  else
    for (std::size_t i = count; i-- > 0;) rows[i + stride] |= rows[i];
}

/// Adds the cells from which it is one step, also a diagonal one, along an octant's directions.
void grow(CellSet& set, unsigned octant) {
  std::uint64_t whole = ~std::uint64_t(0) >> (64 - set.size.x);
  for (auto& row : set.rows) row = (row | (octant & 1u ? row >> 1 : row << 1)) & whole;
  auto ny = std::size_t(set.size.y), nz = std::size_t(set.size.z);
  for (std::size_t z = 0; z < nz; ++z) addNeighbours(&set.rows[z * ny], 1, ny - 1, octant & 2u);
  addNeighbours(set.rows.data(), ny, (nz - 1) * ny, octant & 4u);
}

/// @param map  the octant's part
void writeDistances(CellSet set, unsigned octant, int channel, glm::u8vec2* map) {
  CellSet before(set.size);
  for (std::uint8_t distance = 0; distance < kFarthestLeap && set != before; ++distance) {
    for (std::size_t row = 0; row < set.rows.size(); ++row)
      for (std::uint64_t fresh = set.rows[row] & ~before.rows[row]; fresh != 0; fresh &= fresh - 1)
        map[row * std::size_t(set.size.x) + std::size_t(std::countr_zero(fresh))][channel] = distance;
    before = set;
    grow(set, octant);
  }
}

}  // namespace

std::vector<glm::u8vec2> makeSkipMap(const CellSet& first, const CellSet& second) {
  VELUM_ASSERT(first.size == second.size && first.size.x >= 1 && first.size.x <= 64, "a row of cells is a word");
  std::size_t count = first.rows.size() * std::size_t(first.size.x);
  std::vector<glm::u8vec2> map(8 * count, glm::u8vec2(kFarthestLeap));
  parallelFor(0u, 8u, [&](unsigned octant) {
    writeDistances(first, octant, 0, &map[octant * count]);
    writeDistances(second, octant, 1, &map[octant * count]);
  });
  return map;
}

}  // namespace velum::render
