#pragma once
#include "velum/membrane/forces/Forces.h"

namespace velum::membrane {

/// The room that a sheet has without cutting more than it does. @param below  [y][x] nodes of each column below the
/// sheet
Corridor corridorAround(const CutLattice& lattice, std::span<const int> below);

}  // namespace velum::membrane
