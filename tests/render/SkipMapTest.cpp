#include "upload/SkipMap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace velum::render {
namespace {

std::size_t rowOf(glm::ivec3 size, glm::ivec3 cell) { return std::size_t(cell.z * size.y + cell.y); }

bool holds(const CellSet& set, glm::ivec3 cell) { return set.rows[rowOf(set.size, cell)] >> cell.x & 1; }

/// What makeSkipMap() says, from all pairs of cells.
int plainDistance(const CellSet& set, glm::ivec3 cell) {
  int nearest = kFarthestLeap;
  for (int z = 0; z < set.size.z; ++z)
    for (int y = 0; y < set.size.y; ++y)
      for (int x = 0; x < set.size.x; ++x) {
        glm::ivec3 d = glm::abs(glm::ivec3(x, y, z) - cell);
        if (holds(set, {x, y, z})) nearest = std::min(nearest, std::max({d.x, d.y, d.z}));
      }
  return nearest;
}

void expectEqualsPlainLoop(const CellSet& first, const CellSet& second) {
  auto map = makeSkipMap(first, second);
  glm::ivec3 size = first.size;
  ASSERT_EQ(map.size(), std::size_t(size.x * size.y * size.z));
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        glm::ivec3 cell(x, y, z);
        glm::ivec2 both(map[rowOf(size, cell) * std::size_t(size.x) + std::size_t(x)]);
        ASSERT_EQ(both, glm::ivec2(plainDistance(first, cell), plainDistance(second, cell)))
            << x << " " << y << " " << z << " of " << size.x << " " << size.y << " " << size.z;
      }
}

constexpr glm::ivec3 kSizes[] = {{1, 1, 1}, {64, 3, 5}, {3, 64, 2}, {2, 4, 64}, {63, 7, 1}, {17, 14, 15}};

TEST(SkipMap, EqualsAPlainLoop) {
  std::mt19937 random(5);
  for (glm::ivec3 size : kSizes)
    for (unsigned oneIn : {2u, 40u, 900u}) {
      CellSet first(size), second(size);
      for (std::size_t row = 0; row < first.rows.size(); ++row)
        for (int x = 0; x < size.x; ++x) {
          std::uint64_t bit = std::uint64_t(1) << x;
          if (random() % oneIn == 0) first.rows[row] |= bit;
          if (random() % (4 * oneIn) == 0) second.rows[row] |= bit;
        }
      expectEqualsPlainLoop(first, second);
    }
}

TEST(SkipMap, NothingAndEverythingAndSingleCells) {
  for (glm::ivec3 size : kSizes) {
    CellSet none(size), all(size), corner(size), opposite(size);
    for (auto& row : all.rows) row = ~std::uint64_t(0) >> (64 - size.x);
    corner.rows.front() = 1;
    opposite.rows.back() = std::uint64_t(1) << (size.x - 1);
    expectEqualsPlainLoop(none, all);
    expectEqualsPlainLoop(corner, opposite);
  }
}

}  // namespace
}  // namespace velum::render
