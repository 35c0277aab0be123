#include "membrane/forces/LeastCut.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/Assert.h"
#include "membrane/forces/Bands.h"
#include "membrane/forces/BuildLattice.h"
#include "membrane/forces/ColumnFlow.h"
#include "membrane/forces/OpenParts.h"

namespace velum::membrane {

namespace {

/// Looks further on where a sheet lies at its band's edge: one or two as a rule.
constexpr int kMostRounds = 8;
/// Layers to either side in which a second look smooths a sheet.
constexpr int kSecondLook = 3;
/// Another one is for those that left less than this.
constexpr double kWorthwhile = 0.999;

std::size_t columnCount(const CutLattice& lattice) { return std::size_t(lattice.dims.x) * std::size_t(lattice.dims.y); }

void check(const CutLattice& lattice) {
  if (glm::any(glm::lessThan(lattice.dims, glm::ivec3(1, 1, 2))))
    throw ArgumentError("a lattice for the least cut needs two layers at least");
  VELUM_ASSERT(lattice.first.size() == columnCount(lattice) + 1, "each column has its nodes");
  int flat = flatCount(lattice);
  if (flat < 1 || flat > lattice.dims.z - 1)
    throw ArgumentError("the rest plane at layer " + std::to_string(lattice.restLayer) + " lies outside the lattice");
}

/// What the frame and the reach leave to a sheet: the outermost columns hang on the rest plane.
std::vector<SheetRange> wholeReach(const CutLattice& lattice) {
  std::vector<SheetRange> ranges;
  int flat = flatCount(lattice);
  for (int y = 0; y < lattice.dims.y; ++y)
    for (int x = 0; x < lattice.dims.x; ++x) {
      bool isRim = x == 0 || y == 0 || x + 1 == lattice.dims.x || y + 1 == lattice.dims.y;
      ranges.push_back(isRim ? SheetRange{flat, flat} : SheetRange{1, lattice.dims.z - 1});
    }
  return ranges;
}

/// Each column's range, as far as the whole one lets it.
std::vector<SheetRange> clamped(std::vector<SheetRange> ranges, std::span<const SheetRange> whole) {
  for (std::size_t c = 0; c < ranges.size(); ++c)
    ranges[c] = {std::clamp(ranges[c].low, whole[c].low, whole[c].high),
                 std::clamp(ranges[c].high, whole[c].low, whole[c].high)};
  return ranges;
}

/// How many nodes of each column lie below the sheet above those that are said to be below; where it has a choice, as
/// near to the rest plane as it can be.
std::vector<int> belowOf(const CutLattice& lattice, std::span<const SheetRange> ranges,
                         const std::vector<std::uint8_t>& isBelow) {
  std::vector<int> below;
  int flat = flatCount(lattice);
  for (std::size_t c = 0; c < columnCount(lattice); ++c) {
    int low = 0, high = lattice.dims.z;
    for (std::uint32_t v = lattice.first[c]; v < lattice.first[c + 1]; ++v) {
      if (!isBelow[v]) {
        high = lattice.layer[v];
        break;
      }
      low = lattice.layer[v] + 1;
    }
    below.push_back(std::clamp(std::clamp(flat, low, high), ranges[c].low, ranges[c].high));
  }
  return below;
}

/// The least cut of the sheets within given heights.
LeastCut solve(const CutLattice& lattice, scene::MembraneSide side, std::span<const SheetRange> ranges,
               CutMetric metric, Progress& progress) {
  progress.report(0.0, "finding the least cut");
  CutLattice part = within(lattice, ranges);
  ColumnFlow flow(part, metric, [&](std::size_t column, int layer) {
    SheetRange range = ranges[column];
    return layer < range.low ? ColumnFlow::kBelow : layer >= range.high ? ColumnFlow::kAbove : ColumnFlow::kOpen;
  });
  int phase = 0;
  flow.run([&] { progress.report(1.0 - 20.0 / (20.0 + phase++), "finding the least cut"); });
  return sheetAt(lattice, belowOf(part, ranges, decideOpenParts(part, flow, side, progress)));
}

/// From coarse to fine. @param whole  the heights that there are
LeastCut cutInBands(const CutLattice& lattice, scene::MembraneSide side, CutMetric metric,
                    const std::vector<SheetRange>& whole, Progress& progress, std::size_t exactNodes) {
  if (lattice.layer.size() <= exactNodes || glm::any(glm::lessThan(lattice.dims, glm::ivec3(5))))
    return solve(lattice, side, whole, metric, progress);
  progress.throwIfCancelled();
  LeastCut coarse = cutInBands(coarsened(lattice), side, metric, coarsenedRanges(lattice, whole), progress, exactNodes);
  std::vector<int> sheet = refined(lattice, coarse);
  std::vector<SheetRange> ranges = clamped(bandAround(glm::ivec2(lattice.dims), sheet), whole);
  LeastCut cut = solve(lattice, side, ranges, metric, progress);
  // What a band finds at its edge may lie further on: bands around those places alone.
  for (int round = 0; round < kMostRounds; ++round) {
    std::vector<std::uint8_t> isNear = aroundEdges(glm::ivec2(lattice.dims), cut.below, ranges, whole);
    if (isNear.empty()) break;
    ranges = clamped(bandAround(glm::ivec2(lattice.dims), cut.below), whole);
    for (std::size_t c = 0; c < ranges.size(); ++c)
      if (!isNear[c]) ranges[c] = {cut.below[c], cut.below[c]};
    double last = cut.cutPairs;
    cut = solve(lattice, side, ranges, metric, progress);
    if (cut.cutPairs > kWorthwhile * last) break;
  }
  return cut;
}

}  // namespace

CutLattice makeLattice(glm::ivec3 dims, double restLayer, const PairSource& pairs) {
  constexpr int kUnit = CutLattice::kHalves;
  return buildLattice(dims, restLayer, kUnit, [&](const auto& add) {
    pairs([&](glm::ivec3 node, int axis, double count) { add(node, axis, int(std::lround(kUnit * count))); });
  });
}

CutLattice latticeFromMask(glm::ivec3 dims, double restLayer, std::span<const std::uint8_t> mask) {
  auto count = std::size_t(dims.x) * std::size_t(dims.y) * std::size_t(dims.z);
  if (mask.size() < count) throw ArgumentError("too few nodes in the mask of a lattice");
  std::size_t step[3] = {1, std::size_t(dims.x), std::size_t(dims.x) * std::size_t(dims.y)};
  return makeLattice(dims, restLayer, [&](const auto& add) {
    for (std::size_t at = 0; at < count; ++at) {
      if (!mask[at]) continue;
      glm::ivec3 node(at % step[1], at / step[1] % std::size_t(dims.y), at / step[2]);
      for (int axis = 0; axis < 3; ++axis)
        if (node[axis] + 1 < dims[axis] && mask[at + step[axis]]) add(node, axis, 1.0);
    }
  });
}

int flatCount(const CutLattice& lattice) { return int(std::floor(lattice.restLayer)) + 1; }

std::optional<std::size_t> nodeAt(const CutLattice& lattice, glm::ivec3 node) {
  if (!isWithin(lattice.dims, node)) return std::nullopt;
  std::size_t column = columnOf(lattice.dims, node);
  auto begin = lattice.layer.begin() + lattice.first[column], end = lattice.layer.begin() + lattice.first[column + 1];
  auto found = std::lower_bound(begin, end, std::uint16_t(node.z));
  if (found == end || *found != node.z) return std::nullopt;
  return std::size_t(found - lattice.layer.begin());
}

double pairsAt(const CutLattice& lattice, glm::ivec3 node, int axis) {
  auto found = nodeAt(lattice, node);
  return found ? double(lattice.pairs[axis][*found]) / lattice.unit : 0.0;
}

LeastCut computeLeastCut(const CutLattice& lattice, scene::MembraneSide side, CutMetric metric, Progress& progress) {
  check(lattice);
  return solve(lattice, side, wholeReach(lattice), metric, progress);
}

LeastCut computeLeastCutNear(const CutLattice& lattice, scene::MembraneSide side, CutMetric metric,
                             std::span<const int> near, int band, Progress& progress) {
  check(lattice);
  if (near.size() != columnCount(lattice)) throw ArgumentError("a sheet's columns do not match the lattice");
  std::vector<SheetRange> ranges;
  for (int below : near) ranges.push_back({below - band, below + band});
  ranges = clamped(std::move(ranges), wholeReach(lattice));
  return solve(lattice, side, ranges, metric, progress);
}

LeastCut computeCutInBands(const CutLattice& lattice, scene::MembraneSide side, CutMetric metric, Progress& progress,
                           std::size_t exactNodes) {
  check(lattice);
  return cutInBands(lattice, side, metric, wholeReach(lattice), progress, exactNodes);
}

LeastCut computeSmoothNearPairs(const CutLattice& lattice, scene::MembraneSide side, Progress& progress) {
  LeastCut pairs = computeCutInBands(lattice, side, CutMetric::Pairs, progress);
  return computeLeastCutNear(lattice, side, CutMetric::Smooth, pairs.below, kSecondLook, progress);
}

LeastCut computeCutWithin(const CutLattice& lattice, std::span<const SheetRange> ranges, Progress& progress,
                          std::size_t exactNodes) {
  check(lattice);
  if (ranges.size() != columnCount(lattice)) throw ArgumentError("a sheet's columns do not match the lattice");
  return cutInBands(lattice, scene::MembraneSide::Nearest, CutMetric::Pairs,
                    clamped({ranges.begin(), ranges.end()}, wholeReach(lattice)), progress, exactNodes);
}

LeastCut sheetAt(const CutLattice& lattice, std::vector<int> below) {
  LeastCut cut;
  cut.dims = glm::ivec2(lattice.dims);
  cut.cutPairs = countCutPairs(lattice, below);
  for (std::size_t c = 0; c < below.size(); ++c) {
    auto begin = lattice.layer.begin() + lattice.first[c], end = lattice.layer.begin() + lattice.first[c + 1];
    auto above = std::lower_bound(begin, end, std::uint16_t(std::max(below[c], 0)));
    cut.gap.emplace_back(above == begin ? -1 : int(above[-1]), above == end ? lattice.dims.z : int(*above));
  }
  cut.below = std::move(below);
  return cut;
}

double countCutPairs(const CutLattice& lattice, std::span<const int> below) {
  check(lattice);
  if (below.size() != columnCount(lattice)) throw ArgumentError("a sheet's columns do not match the lattice");
  std::size_t step[2] = {1, std::size_t(lattice.dims.x)};
  std::int64_t units = 0;
  for (std::size_t c = 0; c < below.size(); ++c)
    for (std::uint32_t v = lattice.first[c]; v < lattice.first[c + 1]; ++v) {
      int z = lattice.layer[v];
      if (z == below[c] - 1) units += lattice.pairs[2][v];
      for (int axis = 0; axis < 2; ++axis)
        if (lattice.pairs[axis][v] && (z < below[c]) != (z < below[c + step[axis]])) units += lattice.pairs[axis][v];
    }
  return double(units) / lattice.unit;
}

}  // namespace velum::membrane
