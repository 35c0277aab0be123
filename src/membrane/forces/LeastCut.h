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
  double restLayer = 0.0;  ///< where the rest plane lies, in layers: 3.5 is between layers 3 and 4
  glm::dvec3 origin{0.0};
  glm::dvec3 step{1.0};
  std::vector<std::uint32_t> first;  ///< [y][x]: the lowest node of a column; one more at the end
  std::vector<std::uint16_t> layer;  ///< of each node, ascending within a column
  /// [axis][node]: protected 6-neighbour pairs of voxels that a sheet separates when it passes between the node and the
  /// next one along the axis, each of the strongest as `unit` and weaker ones as less; at most 127 of the former where
  /// all are as strong.
  std::vector<std::uint16_t> pairs[3];
  int unit = kHalves;
  static constexpr int kHalves = 2;  ///< where all are as strong, halves are counted
  /// [node] 1: put in by hand; the sheet passes it on the side that is nearest. Empty: nothing was.
  std::vector<std::uint8_t> isPlaced;
};

/// What a cut costs. By pairs alone, a slanted one costs up to 1.7 times a straight one of the same area, and many that
/// differ in shape cost the same: whatever is picked shows the lattice. Smooth: each diagonal between two nodes in a
/// plane of two axes counts too, as in a cut metric ([MINSURF] 3), and area decides.
enum class CutMetric { Pairs, Smooth };

/// Hands out what lies between nodes: calls its argument with the lower node, the axis to the other one, and pairs.
using PairSource = std::function<void(const std::function<void(glm::ivec3 node, int axis, double pairs)>&)>;

/// A lattice of given pairs; what lies outside is left out, what comes twice adds up.
/// @param pairs  called twice  @throw ArgumentError when a dimension is < 1 or there are more than 65,535 layers
CutLattice makeLattice(glm::ivec3 dims, double restLayer, const PairSource& pairs);
/// A lattice whose nodes are voxels: one pair where both neighbours are protected.
/// @param mask  [z][y][x], 0 or not
CutLattice latticeFromMask(glm::ivec3 dims, double restLayer, std::span<const std::uint8_t> mask);

/// A sheet that separates as little as possible, single valued over the rest plane.
struct LeastCut {
  glm::ivec2 dims{0};
  std::vector<int> below;  ///< [y][x]: nodes of the column that lie below the sheet (kept), as near to the rest plane
                           ///< as the next two let it be
  /// [y][x]: the highest layer with something that lies below the sheet and the lowest with something above it; -1 and
  /// dims.z where there is nothing. Anywhere between them the sheet separates the same.
  std::vector<glm::ivec2> gap;
  double cutPairs = 0.0;  ///< protected pairs that it separates
};

/// The minimum s-t cut of a lattice. Nodes of the first and the last layer and of the
/// outermost columns are tied to their side (a node on the rest plane is below); what lies lower in a column than
/// something below the sheet is below, too. Of all least cuts it is the one that
/// - `side`: keeps, or removes, the parts (pieces that hang together) that the rest plane meets and that need not be
///   cut; what it does not meet stays on its side; nearest: leaves each part on the side on which more of it lies,
///   weighed by its distance from the rest plane;
/// - passes through what must be cut as near to the rest plane as it can, weighed alike.
/// Deterministic. Any thread.
///
/// @param metric  pairs: what no sheet can do better than; smooth: what looks like anatomy, for up to some 15 % more
/// Time goes with the nodes that hold something and with how far cut parts reach: 0.2 to 5 s for half a million to two
/// million, 20 for the blood of a heart at 512^3. @throw ArgumentError when the rest plane lies outside the lattice;
/// Cancelled
LeastCut computeLeastCut(const CutLattice& lattice, scene::MembraneSide side, CutMetric metric, Progress& progress);

/// Nodes up to which the flow is solved exactly: about half a second.
constexpr std::size_t kExactNodes = 100000;

/// A sheet that separates nearly as little, in a fraction of the time: of a lattice twice as coarse, found likewise, it
/// takes the best that there is near that sheet, and looks on around the places where that one lies at the edge of
/// what was looked through [BANDS]. By pairs it is never worse than any coarser one. What it misses is measured, not
/// proved: see docs/PERFORMANCE.md.
/// @param exactNodes  lattices of so many nodes that hold something or fewer are solved exactly
/// @throw as computeLeastCut
LeastCut computeCutInBands(const CutLattice& lattice, scene::MembraneSide side, CutMetric metric, Progress& progress,
                           std::size_t exactNodes = kExactNodes);

/// The same among the sheets within `band` layers of another one in each column: what that sheet becomes when the
/// material has moved a little. The outermost columns hang on the rest plane as ever.
/// @param near  [y][x], as LeastCut::below  @throw as computeLeastCut
LeastCut computeLeastCutNear(const CutLattice& lattice, scene::MembraneSide side, CutMetric metric,
                             std::span<const int> near, int band, Progress& progress);

/// Heights that a sheet may have over a column: how many nodes lie below it, [low, high].
struct SheetRange {
  int low = 0, high = 0;
};

/// The least cut by pairs among the sheets within given heights, of all such the one nearest to the rest plane; in
/// bands as computeCutInBands() does. @param ranges  [y][x]; the outermost columns hang on the rest plane as ever
LeastCut computeCutWithin(const CutLattice& lattice, std::span<const SheetRange> ranges, Progress& progress,
                          std::size_t exactNodes = kExactNodes);

/// Another sheet of a lattice, with its gaps and what it separates. @param below  [y][x], as in LeastCut
LeastCut sheetAt(const CutLattice& lattice, std::vector<int> below);

/// The protected pairs that a sheet separates, weaker ones as parts of one. @param below  [y][x], as in LeastCut
double countCutPairs(const CutLattice& lattice, std::span<const int> below);

/// Which of the nodes one is that holds something; nothing where there is none.
std::optional<std::size_t> nodeAt(const CutLattice& lattice, glm::ivec3 node);
/// Protected pairs between a node and the next one along an axis; 0 outside the lattice.
double pairsAt(const CutLattice& lattice, glm::ivec3 node, int axis);

/// Nodes of each column below the rest plane: the count where the sheet is flat.
int flatCount(const CutLattice& lattice);

}  // namespace velum::membrane
