#include "membrane/forces/Bands.h"

#include <algorithm>
#include <limits>

#include "core/Assert.h"
#include "core/Parallel.h"
#include "membrane/forces/BuildLattice.h"

namespace velum::membrane {

namespace {

/// Layers that a band goes beyond a sheet on either side, and columns that it looks aside.
constexpr int kBand = 3, kAside = 2;
/// Columns that may move along with one in which the sheet may be better further on.
constexpr int kMoving = 8;

/// The nodes of an axis in blocks of two, but for the first and the last one, which stay by themselves: the data ends
/// between them and their neighbours, and a coarse sheet is to find its way around there, too.
class Blocks {
 public:
  /// @param border  a node, not the first, with which a block begins
  explicit Blocks(int nodes, int border = 1) : mNodes(nodes), mShift((border - 1) % 2) {}
  int of(int node) const {
    if (node == 0) return 0;
    return node < mNodes - 1 ? (node - 1 + mShift) / 2 + 1 : of(mNodes - 2) + 1;
  }
  int count() const { return of(mNodes - 1) + 1; }
  int firstOf(int block) const {
    return block <= 0 ? 0 : block >= count() ? mNodes : std::clamp(2 * block - 1 - mShift, 1, mNodes - 1);
  }

 private:
  int mNodes, mShift;
};

}  // namespace

CutLattice coarsened(const CutLattice& lattice) {
  int flat = flatCount(lattice);
  Blocks blocks[3] = {Blocks(lattice.dims.x), Blocks(lattice.dims.y), Blocks(lattice.dims.z, flat)};
  auto blockOf = [&](glm::ivec3 node) {
    return glm::ivec3(blocks[0].of(node.x), blocks[1].of(node.y), blocks[2].of(node.z));
  };
  glm::ivec3 dims(blocks[0].count(), blocks[1].count(), blocks[2].count());
  return buildLattice(dims, blocks[2].of(flat) - 0.5, lattice.unit, [&](const auto& add) {
    parallelFor(0, lattice.dims.y, [&](int y) {
      std::size_t column = std::size_t(y) * std::size_t(lattice.dims.x);
      for (int x = 0; x < lattice.dims.x; ++x, ++column)
        for (std::uint32_t v = lattice.first[column]; v < lattice.first[column + 1]; ++v)
          for (int axis = 0; axis < 3; ++axis) {
            if (lattice.pairs[axis][v] == 0) continue;
            glm::ivec3 node(x, y, lattice.layer[v]), other = node;
            ++other[axis];
            if (blockOf(other) != blockOf(node)) add(blockOf(node), axis, int(lattice.pairs[axis][v]));
          }
    });
  });
}

std::vector<SheetRange> coarsenedRanges(const CutLattice& lattice, std::span<const SheetRange> ranges) {
  Blocks across[2] = {Blocks(lattice.dims.x), Blocks(lattice.dims.y)};
  Blocks layers(lattice.dims.z, flatCount(lattice));
  std::vector<SheetRange> coarse(std::size_t(across[0].count()) * std::size_t(across[1].count()),
                                 {std::numeric_limits<int>::max(), 0});
  for (int y = 0; y < lattice.dims.y; ++y)
    for (int x = 0; x < lattice.dims.x; ++x) {
      SheetRange own = ranges[std::size_t(y) * std::size_t(lattice.dims.x) + std::size_t(x)];
      SheetRange& block = coarse[std::size_t(across[1].of(y) * across[0].count() + across[0].of(x))];
      block = {std::min(block.low, layers.of(own.low)), std::max(block.high, layers.of(own.high))};
    }
  return coarse;
}

std::vector<int> refined(const CutLattice& lattice, const LeastCut& coarse) {
  Blocks across[2] = {Blocks(lattice.dims.x), Blocks(lattice.dims.y)};
  VELUM_ASSERT(coarse.dims == glm::ivec2(across[0].count(), across[1].count()), "a sheet of the coarse lattice");
  Blocks layers(lattice.dims.z, flatCount(lattice));
  std::vector<int> below;
  for (int y = 0; y < lattice.dims.y; ++y)
    for (int x = 0; x < lattice.dims.x; ++x)
      below.push_back(layers.firstOf(coarse.below[std::size_t(across[1].of(y) * coarse.dims.x + across[0].of(x))]));
  return below;
}

std::vector<SheetRange> bandAround(glm::ivec2 columns, std::span<const int> below) {
  std::vector<SheetRange> ranges(below.size());
  parallelFor(0, columns.y, [&](int y) {
    for (int x = 0; x < columns.x; ++x) {
      int low = std::numeric_limits<int>::max(), high = std::numeric_limits<int>::min();
      for (int v = std::max(y - kAside, 0); v <= std::min(y + kAside, columns.y - 1); ++v)
        for (int u = std::max(x - kAside, 0); u <= std::min(x + kAside, columns.x - 1); ++u) {
          int one = below[std::size_t(v * columns.x + u)];
          low = std::min(low, one);
          high = std::max(high, one);
        }
      ranges[std::size_t(y * columns.x + x)] = {low - kBand, high + kBand};
    }
  });
  return ranges;
}

std::vector<std::uint8_t> aroundEdges(glm::ivec2 columns, std::span<const int> below,
                                      std::span<const SheetRange> ranges, std::span<const SheetRange> whole) {
  std::vector<std::uint8_t> isNear;
  auto width = std::size_t(columns.x);
  for (std::size_t c = 0; c < below.size(); ++c) {
    bool isLow = below[c] == ranges[c].low && ranges[c].low > whole[c].low;
    bool isHigh = below[c] == ranges[c].high && ranges[c].high < whole[c].high;
    if (ranges[c].low == ranges[c].high || (!isLow && !isHigh)) continue;
    isNear.resize(below.size());
    glm::ivec2 at(c % width, c / width);
    glm::ivec2 low = glm::max(at - kMoving, 0), high = glm::min(at + kMoving, columns - 1);
    for (int y = low.y; y <= high.y; ++y) {
      auto row = isNear.begin() + std::ptrdiff_t(std::size_t(y) * width);
      std::fill(row + low.x, row + high.x + 1, std::uint8_t(1));
    }
  }
  return isNear;
}

CutLattice within(const CutLattice& lattice, std::span<const SheetRange> ranges) {
  CutLattice part;
  part.dims = lattice.dims;
  part.restLayer = lattice.restLayer;
  part.unit = lattice.unit;
  glm::ivec2 n(lattice.dims);
  auto rangeAt = [&](glm::ivec2 column) {
    return ranges[std::size_t(column.y) * std::size_t(n.x) + std::size_t(column.x)];
  };
  auto append = [](auto& to, const auto& from, std::size_t first, std::size_t end) {
    to.insert(to.end(), from.begin() + std::ptrdiff_t(first), from.begin() + std::ptrdiff_t(end));
  };
  for (int y = 0; y < n.y; ++y)
    for (int x = 0; x < n.x; ++x) {
      // What a neighbour's sheet can pass is tied here, and has its pairs with what is not tied there.
      SheetRange range = rangeAt({x, y});
      for (glm::ivec2 other : {glm::ivec2(x - 1, y), {x + 1, y}, {x, y - 1}, {x, y + 1}}) {
        if (glm::any(glm::lessThan(other, glm::ivec2(0))) || glm::any(glm::greaterThanEqual(other, n))) continue;
        range = {std::min(range.low, rangeAt(other).low), std::max(range.high, rangeAt(other).high)};
      }
      std::size_t column = std::size_t(y) * std::size_t(n.x) + std::size_t(x);
      auto begin = lattice.layer.begin(), end = begin + lattice.first[column + 1];
      auto low = std::lower_bound(begin + lattice.first[column], end, std::uint16_t(std::max(range.low - 1, 0)));
      auto from = std::size_t(low - begin);
      auto to = std::size_t(std::upper_bound(low, end, std::uint16_t(range.high)) - begin);
      part.first.push_back(std::uint32_t(part.layer.size()));
      append(part.layer, lattice.layer, from, to);
      for (int axis = 0; axis < 3; ++axis) append(part.pairs[axis], lattice.pairs[axis], from, to);
      if (!lattice.isPlaced.empty()) append(part.isPlaced, lattice.isPlaced, from, to);
    }
  part.first.push_back(std::uint32_t(part.layer.size()));
  return part;
}

}  // namespace velum::membrane
