#pragma once
#include "membrane/forces/Forces.h"

namespace velum::membrane {

/// The room in which a sheet of a lattice may move without cutting more than it does.
Corridor corridorAround(const CutLattice& lattice, const LeastCut& cut);

}  // namespace velum::membrane
