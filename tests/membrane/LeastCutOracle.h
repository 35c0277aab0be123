#pragma once
#include <functional>
#include <vector>

#include "membrane/forces/LeastCut.h"

/// Two other ways to the least cut of a lattice.
namespace velum::membrane {

/// All sheets of a lattice, one by one: for a handful of free columns. @param visit  gets nodes below, [y][x]
void forEachSheet(const CutLattice& lattice, const std::function<void(const std::vector<int>& below)>& visit);

/// The minimum s-t cut by Boost Graph, over all nodes, as the definition says it: layers at the ends and rim columns
/// tied, infinite edges downwards. In pairs.
double minimumCut(const CutLattice& lattice);

/// A few random tubes across a lattice: [z][y][x], 1 inside.
std::vector<std::uint8_t> tubes(glm::ivec3 dims, int count, double radius, unsigned seed);

}  // namespace velum::membrane
