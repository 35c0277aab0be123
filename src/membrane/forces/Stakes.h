#pragma once
#include <vector>

#include "membrane/forces/Forces.h"
#include "membrane/forces/LeastCut.h"

namespace velum::membrane {

/// The voxels that a sheet in this corridor could leave on the wrong side: those beside it that do not lie in the
/// middle of their node, as in oblique frames. In the order of the voxels.
std::vector<Stake> stakesOf(const ProtectedVoxels& voxels, const scene::Cut& cut, const CutLattice& lattice,
                            const LeastCut& least, const Corridor& corridor);

}  // namespace velum::membrane
