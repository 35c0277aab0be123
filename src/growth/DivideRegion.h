#pragma once
#include <span>
#include <vector>

#include "core/Task.h"
#include "growth/PassageCosts.h"

namespace velum::growth {

/// Whose a voxel of a region is.
enum class Owner : std::uint8_t { Nobody, Own, Others };

/// Divides a region between its own seeds and others: each voxel goes to the kind from which the cheaper way leads to
/// it, to its own where both cost the same ([IFT]: a forest of shortest paths, by buckets as in [DIAL]). Nobody's is
/// what no seed reaches. What is its own is joined to its seeds by faces through what is its own. O(voxels) but for a
/// bucket each for the costs of one step. Five bytes a voxel of the box, and eight for each that waits.
/// @param own, others  places of the box of the costs; those outside of the region are passed over
/// @return [place]  @throw Cancelled
std::vector<Owner> divideRegion(const PassageCosts& costs, std::span<const std::size_t> own,
                                std::span<const std::size_t> others, Progress& progress);

}  // namespace velum::growth
