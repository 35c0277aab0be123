#pragma once
#include <vector>

#include "velum/membrane/forces/LeastCut.h"

namespace velum::membrane {

/// Between which counts of nodes below the sheet each column's sheet may move: low <= below <= high, [y][x].
struct FreeRange {
  std::vector<int> low, high;
};

/// The range that holds a least cut: all layers but the first and last, less what no best sheet needs.
///
/// Above the rest plane, a sheet can be pressed down to layer z in every column outside the row-and-column-convex hull
/// of the columns that hold protected material at z or higher, at no cost: such a column's own edge is a plain one, and
/// the rim of what is left of the layer is no longer than it was, since each edge of it has a ray outwards that met
/// another edge (the sheet returns to the rest plane at the frame). Below the rest plane likewise. Exact for every
/// smoothness and pull.
FreeRange computeFreeRange(const CutLattice& lattice);

}  // namespace velum::membrane
