#include "render/upload/CellGrid.h"

#include <algorithm>
#include <cstdint>

#include "core/Parallel.h"

namespace velum::render {

namespace {
float texelValue(std::uint8_t t) { return float(t) / 255.0f; }
float texelValue(std::uint16_t t) { return float(t) / 65535.0f; }
float texelValue(float t) { return t; }
}  // namespace

CellGrid cellGridFor(glm::ivec3 dims) {
  int edge = 4;
  while (std::max({dims.x, dims.y, dims.z}) > edge * 64) edge *= 2;
  return {edge, (dims + edge - 1) / edge};
}

template <class T>
std::vector<glm::vec2> computeCellRanges(const T* planes, glm::ivec3 dims, const CellGrid& cells, int firstCellZ,
                                         int lastCellZ, int firstPlane) {
  std::vector<glm::vec2> ranges(std::size_t(cells.size.x) * std::size_t(cells.size.y) *
                                std::size_t(lastCellZ - firstCellZ));
  std::size_t planeSize = std::size_t(dims.x) * std::size_t(dims.y);
  // Rows of cells are independent: reduce along z and y into one row of voxels, then along x into cells.
  parallelFor(0, (lastCellZ - firstCellZ) * cells.size.y, [&](int job) {
    int cz = firstCellZ + job / cells.size.y, cy = job % cells.size.y;
    int z0 = std::max(0, cz * cells.edge - 1), z1 = std::min(dims.z, (cz + 1) * cells.edge + 1);
    int y0 = std::max(0, cy * cells.edge - 1), y1 = std::min(dims.y, (cy + 1) * cells.edge + 1);
    std::vector<T> low(std::size_t(dims.x)), high(std::size_t(dims.x));
    const T* first = planes + std::size_t(z0 - firstPlane) * planeSize + std::size_t(y0) * std::size_t(dims.x);
    std::copy_n(first, dims.x, low.begin());
    std::copy_n(first, dims.x, high.begin());
    for (int z = z0; z < z1; ++z)
      for (int y = y0; y < y1; ++y) {
        const T* row = planes + std::size_t(z - firstPlane) * planeSize + std::size_t(y) * std::size_t(dims.x);
        T* lo = low.data();
        T* hi = high.data();
        for (int x = 0; x < dims.x; ++x) {
          lo[x] = row[x] < lo[x] ? row[x] : lo[x];
          hi[x] = row[x] > hi[x] ? row[x] : hi[x];
        }
      }
    glm::vec2* out = &ranges[(std::size_t(cz - firstCellZ) * std::size_t(cells.size.y) + std::size_t(cy)) *
                             std::size_t(cells.size.x)];
    for (int cx = 0; cx < cells.size.x; ++cx) {
      int x0 = std::max(0, cx * cells.edge - 1), x1 = std::min(dims.x, (cx + 1) * cells.edge + 1);
      out[cx] = {texelValue(*std::min_element(low.begin() + x0, low.begin() + x1)),
                 texelValue(*std::max_element(high.begin() + x0, high.begin() + x1))};
    }
  });
  return ranges;
}

template std::vector<glm::vec2> computeCellRanges(const std::uint8_t*, glm::ivec3, const CellGrid&, int, int, int);
template std::vector<glm::vec2> computeCellRanges(const std::uint16_t*, glm::ivec3, const CellGrid&, int, int, int);
template std::vector<glm::vec2> computeCellRanges(const float*, glm::ivec3, const CellGrid&, int, int, int);

}  // namespace velum::render
