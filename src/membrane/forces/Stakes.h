#pragma once
#include <vector>

#include "membrane/forces/Forces.h"
#include "membrane/forces/LeastCut.h"

namespace velum::membrane {

/// The voxels that a sheet within this corridor could still leave on the wrong side: voxels beside the corridor that do
/// not lie exactly on their lattice node, as in oblique frames. In the order of the voxels.
std::vector<Stake> stakesOf(const ProtectedVoxels& voxels, const scene::Cut& cut, const CutLattice& lattice,
                            const LeastCut& least, const Corridor& corridor);

}  // namespace velum::membrane
