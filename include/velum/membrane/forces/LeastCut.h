#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "velum/core/Task.h"

namespace velum::membrane {

/// A regular lattice of nodes aligned with a membrane's rest plane, columns along +z, and how much protected material
/// lies between neighbouring nodes. Frame-local position of a node: origin + node * step.
struct CutLattice {
  glm::ivec3 dims{0};
  double restLayer = 0.0;  ///< where the rest plane lies, in layers: 3.5 is between layers 3 and 4
  glm::dvec3 origin{0.0};
  glm::dvec3 step{1.0};
  /// [axis][z][y][x]: protected 6-neighbour pairs of voxels that a sheet separates when it passes between the node and
  /// the next one along the axis; >= 0, unused at the far ends.
  std::vector<float> pairs[3];
};

/// A lattice with nothing protected. @throw ArgumentError when a dimension is < 1
CutLattice makeLattice(glm::ivec3 dims, double restLayer);
/// A lattice whose nodes are voxels: one pair where both neighbours are protected.
/// @param mask  [z][y][x], 0 or not
CutLattice latticeFromMask(glm::ivec3 dims, double restLayer, std::span<const std::uint8_t> mask);

struct LeastCutOptions {
  double protectedWeight = 200.0;  ///< what it costs to separate one protected pair
  double smoothness = 1.0;         ///< what it costs to pass between any two nodes: the area of the sheet
  double pull = 0.0625;            ///< what a column costs more for each layer between sheet and rest plane
  bool fast = false;               ///< solve coarse lattices first and look only near their sheets
  int band = 2;                    ///< fast: layers to both sides of the coarser sheet
};

/// The sheet of least cost, single valued over the rest plane.
struct LeastCut {
  glm::ivec2 dims{0};
  std::vector<int> below;  ///< [y][x]: nodes of the column that lie below the sheet (kept)
  double cost = 0.0;       ///< by the options' weights
  double cutPairs = 0.0;   ///< protected pairs that it separates
};

/// The minimum s-t cut of a lattice. Nodes of the first and the last layer and of the outermost columns are tied to
/// their side (a node on the rest plane is below); edges downwards are infinite, so that what is below the sheet stays
/// below. A pair of neighbours costs smoothness + protectedWeight * pairs, and a vertical one in addition
/// pull * |its middle - rest plane|, in layers. Capacities are whole multiples of a power of two (1/64 unless weights
/// are huge); in exact mode the result is a true minimum of those, and of several the lowest. Deterministic. Any
/// thread.
///
/// Exact: columns and layers which no best sheet needs to leave the rest plane for are taken out first (see
/// LeastCut.cpp); then incremental breadth-first search [IBFS]. Fast: the same in a band, no guarantee.
/// @throw ArgumentError when the lattice is not sound or the rest plane lies outside it; Cancelled
LeastCut computeLeastCut(const CutLattice& lattice, const LeastCutOptions& options, Progress& progress);

/// The least cut among the sheets within `band` layers of another one in each column: what that sheet becomes when the
/// material has moved a little. The outermost columns hang on the rest plane as ever. Exact; deterministic. Any thread.
/// @param near  [y][x], as LeastCut::below  @throw as computeLeastCut
LeastCut computeLeastCutNear(const CutLattice& lattice, const LeastCutOptions& options, std::span<const int> near,
                             int band, Progress& progress);

/// What a sheet costs, and the protected pairs that it separates. @param below  [y][x], as in LeastCut
LeastCut evaluateSheet(const CutLattice& lattice, const LeastCutOptions& options, std::span<const int> below);

/// Nodes of each column below the rest plane: the count where the sheet is flat.
int flatCount(const CutLattice& lattice);

}  // namespace velum::membrane
