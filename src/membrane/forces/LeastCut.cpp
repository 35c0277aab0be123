#include "velum/membrane/forces/LeastCut.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "FreeRange.h"
#include "GridFlow.h"

namespace velum::membrane {

namespace {

/// Capacities in whole units up to this: sums over a column stay within 32 bits.
constexpr double kLargestCapacity = 1 << 19;
constexpr double kFinestUnit = 64.0;
/// Lattices of no more nodes are solved at once, in some ten milliseconds, rather than in a band: which way round a
/// vessel the sheet goes is decided there, and on coarser ones often wrongly (cost 1.1 to 1.5 times the least on tubes
/// of 4 to 6 voxels in 128 x 128 x 28, against 1.00 to 1.09).
constexpr std::size_t kSmallLattice = 1 << 16;

std::size_t columnCount(const CutLattice& lattice) { return std::size_t(lattice.dims.x) * std::size_t(lattice.dims.y); }
std::size_t nodeCount(const CutLattice& lattice) { return columnCount(lattice) * std::size_t(lattice.dims.z); }

/// Costs of edges in whole units.
class Capacities {
 public:
  Capacities(const CutLattice& lattice, const LeastCutOptions& options) : mLattice(lattice), mOptions(options) {
    float most = 0.0f;
    for (const auto& pairs : lattice.pairs)
      for (float p : pairs) most = std::max(most, p);
    double largest = options.smoothness + options.protectedWeight * double(most) + options.pull * lattice.dims.z;
    mUnits = kFinestUnit;
    while (mUnits * largest > kLargestCapacity) mUnits *= 0.5;
  }
  double units() const { return mUnits; }
  /// From a node to the next along an axis across the rest plane.
  std::int32_t across(int axis, std::size_t node) const {
    return whole(mOptions.smoothness + mOptions.protectedWeight * double(mLattice.pairs[axis][node]));
  }
  /// From a node of layer z to the one above.
  std::int32_t up(int z, std::size_t node) const {
    return whole(mOptions.smoothness + mOptions.protectedWeight * double(mLattice.pairs[2][node]) +
                 mOptions.pull * std::abs(z + 0.5 - mLattice.restLayer));
  }

 private:
  std::int32_t whole(double cost) const { return std::int32_t(std::lround(cost * mUnits)); }
  const CutLattice& mLattice;
  const LeastCutOptions& mOptions;
  double mUnits = 1.0;
};

void check(const CutLattice& lattice, const LeastCutOptions& options) {
  if (glm::any(glm::lessThan(lattice.dims, glm::ivec3(1, 1, 2))))
    throw ArgumentError("a lattice for the least cut needs two layers at least");
  for (const auto& pairs : lattice.pairs)
    if (pairs.size() != nodeCount(lattice)) throw ArgumentError("a lattice's pairs do not match its dimensions");
  int flat = flatCount(lattice);
  if (flat < 1 || flat > lattice.dims.z - 1)
    throw ArgumentError("the rest plane at layer " + std::to_string(lattice.restLayer) + " lies outside the lattice");
  bool isSound = options.protectedWeight >= 0 && options.smoothness >= 0 && options.pull >= 0;
  if (!isSound || !std::isfinite(options.protectedWeight + options.smoothness + options.pull))
    throw ArgumentError("the weights of a least cut must be 0 or more");
}

/// The flow problem of a lattice between fixed ranges.
class Problem {
 public:
  Problem(const CutLattice& lattice, const LeastCutOptions& options, const FreeRange& range)
      : mLattice(lattice), mCapacities(lattice, options), mRange(range), mFlow(boxOf(lattice, range)) {
    for (int y = 0; y < mFlow.dims().y; ++y)
      for (int x = 0; x < mFlow.dims().x; ++x) enliven(x, y);
    for (int y = 0; y < mFlow.dims().y; ++y)
      for (int x = 0; x < mFlow.dims().x; ++x) joinColumn(x, y);
  }

  std::vector<int> solve(Progress& progress) {
    int phase = 0;
    mFlow.run([&] { progress.report(1.0 - 20.0 / (20.0 + phase++), "finding the least cut"); });
    std::vector<int> below = mRange.low;
    for (int y = 0; y < mFlow.dims().y; ++y)
      for (int x = 0; x < mFlow.dims().x; ++x) {
        std::size_t c = columnAt(x, y);
        while (below[c] < mRange.high[c] && mFlow.node(x, y, below[c] - mOrigin.z).tree == GridFlow::kSource)
          ++below[c];
      }
    return below;
  }

 private:
  /// The part of the lattice that is not tied, and where it begins.
  glm::ivec3 boxOf(const CutLattice& lattice, const FreeRange& range) {
    glm::ivec3 low = lattice.dims, high(0);
    for (std::size_t i = 0; i < columnCount(lattice); ++i) {
      if (range.low[i] >= range.high[i]) continue;
      glm::ivec2 c(int(i) % lattice.dims.x, int(i) / lattice.dims.x);
      low = glm::min(low, glm::ivec3(c, range.low[i]));
      high = glm::max(high, glm::ivec3(c + 1, range.high[i]));
    }
    mOrigin = glm::min(low, high);
    return high - mOrigin;
  }
  std::size_t columnAt(int x, int y) const {
    return std::size_t(y + mOrigin.y) * std::size_t(mLattice.dims.x) + std::size_t(x + mOrigin.x);
  }
  std::size_t nodeAt(std::size_t column, int z) const { return std::size_t(z) * columnCount(mLattice) + column; }

  void enliven(int x, int y) {
    std::size_t c = columnAt(x, y);
    for (int z = mRange.low[c]; z < mRange.high[c]; ++z) mFlow.node(x, y, z - mOrigin.z).tree = GridFlow::kFree;
  }

  void joinColumn(int x, int y) {
    std::size_t c = columnAt(x, y);
    int low = mRange.low[c], high = mRange.high[c];
    if (low >= high) return;
    mFlow.node(x, y, low - mOrigin.z).terminal += mCapacities.up(low - 1, nodeAt(c, low - 1));
    for (int z = low; z < high; ++z) {
      GridFlow::Node& node = mFlow.node(x, y, z - mOrigin.z);
      std::int32_t up = mCapacities.up(z, nodeAt(c, z));
      if (z + 1 < high)
        node.up = up;
      else
        node.terminal -= up;
      joinSides(node, x, y, z);
    }
  }

  /// Capacities to the neighbours across; of tied neighbours to their terminal.
  void joinSides(GridFlow::Node& node, int x, int y, int z) {
    constexpr int kStep[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    for (int direction = 0; direction < 4; ++direction) {
      int u = x + kStep[direction][0] + mOrigin.x, v = y + kStep[direction][1] + mOrigin.y;
      if (u < 0 || v < 0 || u >= mLattice.dims.x || v >= mLattice.dims.y) continue;
      std::size_t own = columnAt(x, y), other = std::size_t(v) * std::size_t(mLattice.dims.x) + std::size_t(u);
      std::int32_t capacity = mCapacities.across(direction / 2, nodeAt(direction & 1 ? other : own, z));
      if (z < mRange.low[other])
        node.terminal += capacity;
      else if (z >= mRange.high[other])
        node.terminal -= capacity;
      else
        node.side[direction] = capacity;
    }
  }

  const CutLattice& mLattice;
  Capacities mCapacities;
  const FreeRange& mRange;
  glm::ivec3 mOrigin{0};
  GridFlow mFlow;
};

/// A lattice of nodes twice as large; the rest plane stays on the same boundary between layers.
struct Coarser {
  CutLattice lattice;
  int pad = 0;  ///< layers added below, so that the boundary is an even one
};

Coarser coarsen(const CutLattice& fine) {
  Coarser coarse;
  coarse.pad = flatCount(fine) & 1;
  glm::ivec3 dims((fine.dims.x + 1) / 2, (fine.dims.y + 1) / 2, (fine.dims.z + coarse.pad + 1) / 2);
  coarse.lattice = makeLattice(dims, (flatCount(fine) + coarse.pad) / 2 - 0.5);
  std::size_t at = 0;
  for (int z = 0; z < fine.dims.z; ++z)
    for (int y = 0; y < fine.dims.y; ++y)
      for (int x = 0; x < fine.dims.x; ++x, ++at) {
        glm::ivec3 p(x, y, z + coarse.pad);
        std::size_t to = (std::size_t(p.z / 2) * std::size_t(dims.y) + std::size_t(p.y / 2)) * std::size_t(dims.x) +
                         std::size_t(p.x / 2);
        for (int axis = 0; axis < 3; ++axis)
          if (p[axis] & 1) coarse.lattice.pairs[axis][to] += fine.pairs[axis][at];
      }
  return coarse;
}

/// The counts within `band` of a coarser sheet, its neighbouring columns included.
void narrow(FreeRange& range, const CutLattice& fine, const Coarser& coarse, std::span<const int> coarseBelow,
            int band) {
  glm::ivec2 n(coarse.lattice.dims);
  for (int y = 0; y < fine.dims.y; ++y)
    for (int x = 0; x < fine.dims.x; ++x) {
      int low = fine.dims.z, high = 0;
      for (int v = std::max(y / 2 - 1, 0); v <= std::min(y / 2 + 1, n.y - 1); ++v)
        for (int u = std::max(x / 2 - 1, 0); u <= std::min(x / 2 + 1, n.x - 1); ++u) {
          int below = coarseBelow[std::size_t(v) * std::size_t(n.x) + std::size_t(u)] * 2 - coarse.pad;
          low = std::min(low, below - band);
          high = std::max(high, below + band);
        }
      std::size_t c = std::size_t(y) * std::size_t(fine.dims.x) + std::size_t(x);
      low = std::clamp(low, range.low[c], range.high[c]);
      range.high[c] = std::clamp(high, low, range.high[c]);
      range.low[c] = low;
    }
}

std::vector<int> solve(const CutLattice& lattice, const LeastCutOptions& options, Progress& progress) {
  FreeRange range = computeFreeRange(lattice);
  glm::ivec3 n = lattice.dims;
  if (options.fast && nodeCount(lattice) > kSmallLattice && std::min(n.x, n.y) > 8 && n.z > 6) {
    Coarser coarse = coarsen(lattice);
    LeastCutOptions coarseOptions = options;
    coarseOptions.smoothness *= 4.0;
    coarseOptions.pull *= 8.0;
    narrow(range, lattice, coarse, solve(coarse.lattice, coarseOptions, progress), options.band);
  }
  progress.throwIfCancelled();
  return Problem(lattice, options, range).solve(progress);
}

}  // namespace

CutLattice makeLattice(glm::ivec3 dims, double restLayer) {
  if (glm::any(glm::lessThan(dims, glm::ivec3(1)))) throw ArgumentError("a lattice needs one node along each axis");
  CutLattice lattice;
  lattice.dims = dims;
  lattice.restLayer = restLayer;
  for (auto& pairs : lattice.pairs) pairs.assign(nodeCount(lattice), 0.0f);
  return lattice;
}

CutLattice latticeFromMask(glm::ivec3 dims, double restLayer, std::span<const std::uint8_t> mask) {
  CutLattice lattice = makeLattice(dims, restLayer);
  if (mask.size() < nodeCount(lattice)) throw ArgumentError("too few nodes in the mask of a lattice");
  std::size_t step[3] = {1, std::size_t(dims.x), columnCount(lattice)};
  std::size_t at = 0;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x, ++at)
        for (int axis = 0; axis < 3; ++axis)
          if (glm::ivec3(x, y, z)[axis] + 1 < dims[axis] && mask[at] && mask[at + step[axis]])
            lattice.pairs[axis][at] = 1.0f;
  return lattice;
}

int flatCount(const CutLattice& lattice) { return int(std::floor(lattice.restLayer)) + 1; }

LeastCut computeLeastCut(const CutLattice& lattice, const LeastCutOptions& options, Progress& progress) {
  check(lattice, options);
  progress.report(0.0, "finding the least cut");
  return evaluateSheet(lattice, options, solve(lattice, options, progress));
}

LeastCut computeLeastCutNear(const CutLattice& lattice, const LeastCutOptions& options, std::span<const int> near,
                             int band, Progress& progress) {
  check(lattice, options);
  if (near.size() != columnCount(lattice)) throw ArgumentError("a sheet's columns do not match the lattice");
  progress.report(0.0, "following the material");
  int flat = flatCount(lattice), highest = lattice.dims.z - 1;
  FreeRange range{std::vector<int>(near.size(), flat), std::vector<int>(near.size(), flat)};
  for (int y = 1; y < lattice.dims.y - 1; ++y)
    for (int x = 1; x < lattice.dims.x - 1; ++x) {
      std::size_t c = std::size_t(y) * std::size_t(lattice.dims.x) + std::size_t(x);
      range.low[c] = std::clamp(near[c] - band, 1, highest);
      range.high[c] = std::clamp(near[c] + band, 1, highest);
    }
  return evaluateSheet(lattice, options, Problem(lattice, options, range).solve(progress));
}

LeastCut evaluateSheet(const CutLattice& lattice, const LeastCutOptions& options, std::span<const int> below) {
  check(lattice, options);
  if (below.size() != columnCount(lattice)) throw ArgumentError("a sheet's columns do not match the lattice");
  glm::ivec3 n = lattice.dims;
  LeastCut sheet{glm::ivec2(n), {below.begin(), below.end()}};
  double plain = 0.0, pulls = 0.0;
  for (int y = 0; y < n.y; ++y)
    for (int x = 0; x < n.x; ++x) {
      std::size_t c = std::size_t(y) * std::size_t(n.x) + std::size_t(x);
      if (below[c] < 1 || below[c] > n.z - 1) throw ArgumentError("a sheet leaves its lattice");
      sheet.cutPairs += double(lattice.pairs[2][std::size_t(below[c] - 1) * columnCount(lattice) + c]);
      plain += 1.0;
      pulls += std::abs(below[c] - 0.5 - lattice.restLayer);
      for (int axis = 0; axis < 2; ++axis) {
        if (axis == 0 ? x + 1 == n.x : y + 1 == n.y) continue;
        int other = below[c + (axis == 0 ? 1 : std::size_t(n.x))];
        for (int z = std::min(below[c], other); z < std::max(below[c], other); ++z) {
          sheet.cutPairs += double(lattice.pairs[axis][std::size_t(z) * columnCount(lattice) + c]);
          plain += 1.0;
        }
      }
    }
  sheet.cost = options.protectedWeight * sheet.cutPairs + options.smoothness * plain + options.pull * pulls;
  return sheet;
}

}  // namespace velum::membrane
