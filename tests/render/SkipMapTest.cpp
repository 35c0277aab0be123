#include "render/upload/SkipMap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace velum::render {
namespace {

std::size_t rowOf(glm::ivec3 size, glm::ivec3 cell) { return std::size_t(cell.z * size.y + cell.y); }

bool holds(const CellSet& set, glm::ivec3 cell) { return set.rows[rowOf(set.size, cell)] >> cell.x & 1; }

/// What makeSkipMap() says, from all pairs of cells.
int plainDistance(const CellSet& set, int octant, glm::ivec3 cell) {
  int nearest = kFarthestLeap;
  for (int z = 0; z < set.size.z; ++z)
    for (int y = 0; y < set.size.y; ++y)
      for (int x = 0; x < set.size.x; ++x) {
        glm::ivec3 d = (glm::ivec3(x, y, z) - cell) * (2 * glm::ivec3(octant & 1, octant >> 1 & 1, octant >> 2) - 1);
        bool liesThatWay = d.x >= 0 && d.y >= 0 && d.z >= 0;
        if (liesThatWay && holds(set, {x, y, z})) nearest = std::min(nearest, std::max({d.x, d.y, d.z}));
      }
  return nearest;
}

void expectEqualsPlainLoop(const CellSet& first, const CellSet& second) {
  auto map = makeSkipMap(first, second);
  glm::ivec3 size = first.size;
  glm::ivec3 all = skipMapSize(size);
  ASSERT_EQ(map.size(), std::size_t(all.x * all.y * all.z));
  for (std::size_t i = 0; i < map.size(); ++i) {
    int layer = int(i) / (size.x * size.y);
    glm::ivec3 cell(int(i) % size.x, int(i) / size.x % size.y, layer % size.z);
    int octant = layer / size.z;
    ASSERT_EQ(glm::ivec2(map[i]), glm::ivec2(plainDistance(first, octant, cell), plainDistance(second, octant, cell)))
        << cell.x << " " << cell.y << " " << cell.z << " of " << size.x << " " << size.y << " " << size.z << ", octant "
        << octant;
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
