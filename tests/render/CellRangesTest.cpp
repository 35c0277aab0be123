#include <gtest/gtest.h>

#include <limits>

#include "makeVolume.h"
#include "render/upload/CellGrid.h"

namespace velum::render {
namespace {

template <class T>
void expectEqualsPlainLoop(glm::ivec3 dims, double scale, double texelScale) {
  CellGrid cells = cellGridFor(dims);
  std::vector<T> samples;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x) samples.push_back(T(hashNoise({x, y, z}) * scale));
  auto ranges = computeCellRanges(samples.data(), dims, cells, 0, cells.size.z, 0);
  ASSERT_EQ(ranges.size(), std::size_t(cells.size.x) * std::size_t(cells.size.y) * std::size_t(cells.size.z));
  for (int cz = 0; cz < cells.size.z; ++cz)
    for (int cy = 0; cy < cells.size.y; ++cy)
      for (int cx = 0; cx < cells.size.x; ++cx) {
        glm::ivec3 low = glm::max(glm::ivec3(cx, cy, cz) * cells.edge - 1, glm::ivec3(0));
        glm::ivec3 high = glm::min(glm::ivec3(cx + 1, cy + 1, cz + 1) * cells.edge + 1, dims);
        double smallest = 1e300, largest = -1e300;
        for (int z = low.z; z < high.z; ++z)
          for (int y = low.y; y < high.y; ++y)
            for (int x = low.x; x < high.x; ++x) {
              double v = double(samples[(std::size_t(z) * std::size_t(dims.y) + std::size_t(y)) * std::size_t(dims.x) +
                                        std::size_t(x)]);
              smallest = std::min(smallest, v), largest = std::max(largest, v);
            }
        glm::vec2 range =
            ranges[(std::size_t(cz) * std::size_t(cells.size.y) + std::size_t(cy)) * std::size_t(cells.size.x) +
                   std::size_t(cx)];
        EXPECT_FLOAT_EQ(range.x, float(smallest / texelScale));
        EXPECT_FLOAT_EQ(range.y, float(largest / texelScale));
      }
}

TEST(CellRanges, EqualAPlainLoop) {
  for (glm::ivec3 dims : {glm::ivec3(17, 9, 13), glm::ivec3(1, 1, 1), glm::ivec3(4, 8, 12), glm::ivec3(300, 5, 3),
                          glm::ivec3(33, 1, 70)}) {
    SCOPED_TRACE(dims.x);
    expectEqualsPlainLoop<std::uint8_t>(dims, 255, 255);
    expectEqualsPlainLoop<std::uint16_t>(dims, 65535, 65535);
    expectEqualsPlainLoop<float>(dims, -3000, 1);
  }
}

TEST(CellRanges, SlabsTogetherEqualTheWhole) {
  glm::ivec3 dims(21, 15, 30);
  CellGrid cells = cellGridFor(dims);
  std::vector<float> samples;
  for (int i = 0; i < 21 * 15 * 30; ++i) samples.push_back(float(hashNoise({i, 0, 0})));
  auto whole = computeCellRanges(samples.data(), dims, cells, 0, cells.size.z, 0);
  std::vector<glm::vec2> parts;
  for (int cz = 0; cz < cells.size.z; ++cz) {
    int firstPlane = std::max(0, cz * cells.edge - 1);
    auto part = computeCellRanges(samples.data() + firstPlane * 21 * 15, dims, cells, cz, cz + 1, firstPlane);
    parts.insert(parts.end(), part.begin(), part.end());
  }
  EXPECT_EQ(parts, whole);
}

TEST(CellGrid, CoversTheVolumeWithAtMost64Cells) {
  for (glm::ivec3 dims :
       {glm::ivec3(1), glm::ivec3(256), glm::ivec3(257), glm::ivec3(2048, 3, 700), glm::ivec3(5000, 1, 1)}) {
    CellGrid cells = cellGridFor(dims);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GE(cells.size[axis] * cells.edge, dims[axis]);
      EXPECT_LT((cells.size[axis] - 1) * cells.edge, dims[axis]);
      EXPECT_LE(cells.size[axis], 64);
    }
  }
}

}  // namespace
}  // namespace velum::render
