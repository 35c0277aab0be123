#pragma once
#include <cstdint>
#include <vector>

#include "membrane/forces/ColumnFlow.h"

namespace velum::membrane {

/// Decides on which side the nodes lie that a maximum flow leaves undecided. Any choice is a least cut as long as no
/// node is below the sheet without the nodes that must then be below, too.
/// @param side  which side undecided parts go to; parts that must be cut are cut as near to the rest plane as possible
/// @return for each node: 1 below the sheet, 0 above
std::vector<std::uint8_t> decideOpenParts(const CutLattice& lattice, const ColumnFlow& flow, scene::MembraneSide side,
                                          Progress& progress);

}  // namespace velum::membrane
