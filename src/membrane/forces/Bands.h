#pragma once
#include <span>
#include <vector>

#include "membrane/forces/LeastCut.h"

namespace velum::membrane {

/// A lattice with two nodes along each axis made one, but for the first and the last, whose sheets are those of the
/// fine one that have whole nodes on either side: each separates in both the same, up to 127 pairs between two nodes.
/// The rest plane stays between two layers. Four nodes along an axis may stay as many.
CutLattice coarsened(const CutLattice& lattice);

/// Heights of the sheets of a lattice as those of coarsened(lattice), as many as one of the columns of each has.
std::vector<SheetRange> coarsenedRanges(const CutLattice& lattice, std::span<const SheetRange> ranges);

/// A sheet of coarsened(lattice) as one of the lattice, see LeastCut::below.
std::vector<int> refined(const CutLattice& lattice, const LeastCut& coarse);

/// The heights near a sheet: near what it has over a column and over those around it, so that a wall between two
/// columns may move to either side.
std::vector<SheetRange> bandAround(glm::ivec2 columns, std::span<const int> below);

/// Columns near those in which a sheet lies at the edge of its range though the lattice goes on, so that it may be
/// better further on. @return empty where there are none
std::vector<std::uint8_t> aroundEdges(glm::ivec2 columns, std::span<const int> below,
                                      std::span<const SheetRange> ranges, std::span<const SheetRange> whole);

/// What of a lattice the sheets of given heights can meet, and the nodes that tie it at its ends. Dimensions and
/// columns stay; origin and step are left out.
CutLattice within(const CutLattice& lattice, std::span<const SheetRange> ranges);

}  // namespace velum::membrane
