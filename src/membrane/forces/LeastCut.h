#pragma once
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/Task.h"
#include "scene/Membrane.h"

namespace velum::membrane {

/// A regular lattice of nodes aligned with a membrane's rest plane, columns along +z, and how much protected material
/// lies between neighbouring nodes. Frame-local position of a node: origin + node * step. Only nodes that hold
/// something are kept: eight bytes each, and four a column.
struct CutLattice {
  glm::ivec3 dims{0};
  double restLayer = 0.0;  ///< height of the rest plane, in layers: 3.5 is between layers 3 and 4
  glm::dvec3 origin{0.0};
  glm::dvec3 step{1.0};
  std::vector<std::uint32_t> first;  ///< [y][x]: index of the lowest node of each column; one more entry at the end
  std::vector<std::uint16_t> layer;  ///< of each node, ascending within a column
  /// [axis][node]: protected 6-neighbour pairs of voxels that a sheet separates when it passes between the node and the
  /// next one along the axis. A pair of the strongest material counts as `unit`, weaker ones as less; at most 127 pairs
  /// where all are equally strong.
  std::vector<std::uint16_t> pairs[3];
  int unit = kHalves;
  static constexpr int kHalves = 2;  ///< where all pairs are equally strong, halves of pairs are counted
  /// [node] 1: the node's material was put in by hand, and the sheet passes it on the nearest side. Empty: nothing was
  /// put in by hand.
  std::vector<std::uint8_t> isPlaced;
};

/// How the cost of a cut is measured. Pairs: a slanted cut costs up to 1.7 times a straight one of the same area, and
/// many cuts of different shapes cost the same, so that whichever is picked shows the lattice. Smooth: each diagonal
/// between two nodes in a plane of two axes counts, too, as in a cut metric ([MINSURF] 3), so that the cut's area
/// decides.
enum class CutMetric { Pairs, Smooth };

/// Hands out the pairs between nodes: calls its argument with the lower node, the axis along which the other node
/// follows, and the number of pairs.
using PairSource = std::function<void(const std::function<void(glm::ivec3 node, int axis, double pairs)>&)>;

/// A lattice made from pairs. Pairs outside the lattice are left out; pairs handed out several times add up.
/// @param pairs  source of the pairs; called twice @throw ArgumentError when a dimension is < 1 or there are more than
/// 65,535 layers
CutLattice makeLattice(glm::ivec3 dims, double restLayer, const PairSource& pairs);
/// A lattice whose nodes are voxels: one pair where both neighbours are protected.
/// @param mask  [z][y][x], not 0 where a voxel is protected
CutLattice latticeFromMask(glm::ivec3 dims, double restLayer, std::span<const std::uint8_t> mask);

/// A sheet that separates as little as possible, single valued over the rest plane.
struct LeastCut {
  glm::ivec2 dims{0};
  std::vector<int> below;  ///< [y][x]: how many nodes of the column lie below the sheet (kept); as near to the rest
                           ///< plane as `gap` and `cutPairs` allow
  /// [y][x]: the highest layer with protected material below the sheet, and the lowest with protected material above
  /// it; -1 and dims.z where there is none. Anywhere between these two layers the sheet separates the same pairs.
  std::vector<glm::ivec2> gap;
  double cutPairs = 0.0;  ///< protected pairs that the sheet separates
};

/// The minimum s-t cut of a lattice. Nodes of the first and the last layer and of the outermost columns are tied to
/// their side (a node on the rest plane is below); every node under a node below the sheet is below it, too. Of all
/// least cuts the result is the one that
/// - `side`: keeps, or removes, all parts (pieces that hang together) that the rest plane meets and that need not be
///   cut, while parts that the rest plane does not meet stay on their side; nearest: leaves each part on the side on
///   which more of it lies, weighted by the distance from the rest plane;
/// - passes through parts that must be cut as near to the rest plane as it can, weighted in the same way.
///   Deterministic. Any thread.
///
/// @param metric  pairs: no sheet separates fewer; smooth: the result looks more like anatomy, for up to some 15 % more
/// pairs Time grows with the number of nodes that hold something and with how far cut parts reach: 0.2 to 5 s for half
/// a million to two million nodes, 20 s for the blood of a heart at 512^3. @throw ArgumentError when the rest plane
/// lies outside the lattice; Cancelled
LeastCut computeLeastCut(const CutLattice& lattice, scene::MembraneSide side, CutMetric metric, Progress& progress);

/// Nodes up to which the flow is solved exactly: about half a second.
constexpr std::size_t kExactNodes = 100000;

/// A sheet that separates nearly as little, in a fraction of the time [BANDS]. The sheet of a lattice twice as coarse
/// is found first, in the same way; then the best sheet near that one is taken, and wherever the best lies at the edge
/// of the searched heights the search is widened. By pairs the result is never worse than the sheet of any coarser
/// lattice. How much it misses is measured, not proved: see docs/PERFORMANCE.md.
/// @param exactNodes  lattices with at most so many nodes that hold something are solved exactly
/// @throw as computeLeastCut
LeastCut computeCutInBands(const CutLattice& lattice, scene::MembraneSide side, CutMetric metric, Progress& progress,
                           std::size_t exactNodes = kExactNodes);

/// The least cut among the sheets that lie, in each column, within `band` layers of the sheet `near`: for a sheet whose
/// material has moved a little. The outermost columns stay tied to the rest plane.
/// @param near  [y][x], as LeastCut::below @throw as computeLeastCut
LeastCut computeLeastCutNear(const CutLattice& lattice, scene::MembraneSide side, CutMetric metric,
                             std::span<const int> near, int band, Progress& progress);

/// The heights that a sheet may have in a column, as the number of nodes below the sheet, from low to high, both
/// included.
struct SheetRange {
  int low = 0, high = 0;
};

/// A smooth sheet of a lattice with millions of nodes, in two looks: computeCutInBands() by pairs, then the least cut
/// by the smooth metric within a few layers of that sheet. Bands of the smooth metric miss thin structures that coarse
/// lattices do not tell apart: among vessels of 1.7 million nodes this takes a quarter of their time, and the sheet
/// separates two thirds of their pairs, 2 % more than by pairs alone. @throw as computeLeastCut
LeastCut computeSmoothNearPairs(const CutLattice& lattice, scene::MembraneSide side, Progress& progress);

/// The least cut by pairs among the sheets within given heights; of several the one nearest to the rest plane. Works in
/// bands as computeCutInBands() does. @param ranges  [y][x]; the outermost columns stay tied to the rest plane
LeastCut computeCutWithin(const CutLattice& lattice, std::span<const SheetRange> ranges, Progress& progress,
                          std::size_t exactNodes = kExactNodes);

/// The LeastCut of any sheet of a lattice, with its gaps and the pairs that it separates. @param below  [y][x], as in
/// LeastCut
LeastCut sheetAt(const CutLattice& lattice, std::vector<int> below);

/// The number of protected pairs that a sheet separates; weaker pairs count as fractions. @param below  [y][x], as in
/// LeastCut
double countCutPairs(const CutLattice& lattice, std::span<const int> below);

/// Index of the node at a position of the lattice; nothing where the node there holds nothing.
std::optional<std::size_t> nodeAt(const CutLattice& lattice, glm::ivec3 node);
/// Protected pairs between a node and the next one along an axis; 0 outside the lattice.
double pairsAt(const CutLattice& lattice, glm::ivec3 node, int axis);

/// How many nodes of each column lie below the rest plane: LeastCut::below of the flat sheet.
int flatCount(const CutLattice& lattice);

}  // namespace velum::membrane
