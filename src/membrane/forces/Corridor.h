#pragma once
#include "membrane/forces/Forces.h"

namespace velum::membrane {

/// The room that a sheet of a lattice has without cutting more than it does.
Corridor corridorAround(const CutLattice& lattice, const LeastCut& cut);

}  // namespace velum::membrane
