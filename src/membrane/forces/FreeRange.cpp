#include "FreeRange.h"

#include <algorithm>
#include <cstdint>

namespace velum::membrane {

namespace {

using Columns = std::vector<std::uint8_t>;

/// Fills each line of columns between its first and its last. @return whether that changed anything
bool fillLines(Columns& columns, int lines, int lineStep, int count, int step) {
  bool changed = false;
  for (int line = 0; line < lines; ++line) {
    std::uint8_t* p = columns.data() + std::ptrdiff_t(line) * lineStep;
    int first = 0, last = count - 1;
    while (first < count && !p[std::ptrdiff_t(first) * step]) ++first;
    while (last > first && !p[std::ptrdiff_t(last) * step]) --last;
    for (int i = first; i < last; ++i) {
      changed |= !p[std::ptrdiff_t(i) * step];
      p[std::ptrdiff_t(i) * step] = 1;
    }
  }
  return changed;
}

/// The smallest set around the columns that every row and every column meets in one piece.
void makeConvex(Columns& columns, glm::ivec2 dims) {
  while (fillLines(columns, dims.y, dims.x, dims.x, 1) | fillLines(columns, dims.x, 1, dims.y, dims.x)) {
  }
}

/// Marks the columns that have protected pairs at a layer's nodes.
void markLayer(const CutLattice& lattice, int z, Columns& columns) {
  glm::ivec3 n = lattice.dims;
  std::size_t layer = std::size_t(n.x) * std::size_t(n.y), at = layer * std::size_t(z);
  for (int y = 0; y < n.y; ++y)
    for (int x = 0; x < n.x; ++x, ++at) {
      bool found = (x + 1 < n.x && lattice.pairs[0][at] > 0) || (x > 0 && lattice.pairs[0][at - 1] > 0) ||
                   (y + 1 < n.y && lattice.pairs[1][at] > 0) ||
                   (y > 0 && lattice.pairs[1][at - std::size_t(n.x)] > 0) ||
                   (z + 1 < n.z && lattice.pairs[2][at] > 0) || (z > 0 && lattice.pairs[2][at - layer] > 0);
      if (found) columns[std::size_t(y) * std::size_t(n.x) + std::size_t(x)] = 1;
    }
}

}  // namespace

FreeRange computeFreeRange(const CutLattice& lattice) {
  glm::ivec3 n = lattice.dims;
  int flat = flatCount(lattice);
  std::size_t count = std::size_t(n.x) * std::size_t(n.y);
  FreeRange range{std::vector<int>(count, flat), std::vector<int>(count, flat)};
  auto isInner = [&](std::size_t column) {
    int x = int(column % std::size_t(n.x)), y = int(column / std::size_t(n.x));
    return x > 0 && y > 0 && x < n.x - 1 && y < n.y - 1;
  };
  // From the ends of the reach towards the rest plane, so that the hulls grow.
  Columns columns(count, 0);
  for (int z = n.z - 1; z >= flat; --z) {
    markLayer(lattice, z, columns);
    makeConvex(columns, {n.x, n.y});
    for (std::size_t i = 0; i < count; ++i)
      if (columns[i] && isInner(i)) range.high[i] = std::max(range.high[i], std::min(z + 1, n.z - 1));
  }
  columns.assign(count, 0);
  for (int z = 0; z < flat; ++z) {
    markLayer(lattice, z, columns);
    makeConvex(columns, {n.x, n.y});
    for (std::size_t i = 0; i < count; ++i)
      if (columns[i] && isInner(i)) range.low[i] = std::min(range.low[i], std::max(z, 1));
  }
  return range;
}

}  // namespace velum::membrane
