#pragma once
#include <span>
#include <vector>

#include "membrane/forces/LeastCut.h"

namespace velum::membrane {

/// A lattice in which each two nodes along an axis are joined to one, except the first and the last node. Its sheets
/// are those sheets of the fine lattice that leave joined nodes whole; each such sheet separates the same pairs in both
/// lattices, up to 127 pairs between two nodes. The rest plane stays between two layers. An axis with four nodes may
/// keep all four.
CutLattice coarsened(const CutLattice& lattice);

/// Ranges of heights over a lattice, turned into ranges over coarsened(lattice): of joined columns the union.
std::vector<SheetRange> coarsenedRanges(const CutLattice& lattice, std::span<const SheetRange> ranges);

/// A sheet of coarsened(lattice) as a sheet of `lattice`, see LeastCut::below.
std::vector<int> refined(const CutLattice& lattice, const LeastCut& coarse);

/// The ranges of heights near a sheet: near the sheet's height in the column itself and in the columns around it, so
/// that a wall between two columns may move to either side.
std::vector<SheetRange> bandAround(glm::ivec2 columns, std::span<const int> below);

/// Marks the columns near those in which a sheet lies at the edge of its range although the whole range goes on, so
/// that a better sheet may lie beyond the edge. @return empty where there are no such columns
std::vector<std::uint8_t> aroundEdges(glm::ivec2 columns, std::span<const int> below,
                                      std::span<const SheetRange> ranges, std::span<const SheetRange> whole);

/// The part of a lattice that sheets with heights in the given ranges can meet, with the nodes at its ends that tie it
/// to the two sides. Dimensions and columns stay as they are; origin and step are not filled in.
CutLattice within(const CutLattice& lattice, std::span<const SheetRange> ranges);

}  // namespace velum::membrane
