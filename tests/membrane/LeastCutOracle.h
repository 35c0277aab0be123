#pragma once
#include "velum/membrane/forces/LeastCut.h"

/// Two other ways to the least cut of a lattice.
namespace velum::membrane {

/// The least cost of all sheets, one by one: for a handful of free columns.
double bestOfAllSheets(const CutLattice& lattice, const LeastCutOptions& options);

/// The minimum s-t cut by Boost Graph, over all nodes, as the definition says it: layers at the ends and rim columns
/// tied, infinite edges downwards.
double minimumCut(const CutLattice& lattice, const LeastCutOptions& options);

}  // namespace velum::membrane
