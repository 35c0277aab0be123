#pragma once
#include <cstdint>
#include <vector>

#include "membrane/forces/ColumnFlow.h"

namespace velum::membrane {

/// Decides what a full flow leaves open: each choice that never has a node below the sheet without those that must
/// follow it is a least cut.
/// @param side  of parts of which nothing is decided; those that must be cut are cut as near to the rest plane as can
/// be
/// @return of each node, 1 below the sheet, 0 above
std::vector<std::uint8_t> decideOpenParts(const CutLattice& lattice, const ColumnFlow& flow, scene::MembraneSide side,
                                          Progress& progress);

}  // namespace velum::membrane
