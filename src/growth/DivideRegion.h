#pragma once
#include <span>
#include <vector>

#include "core/Task.h"
#include "growth/PassageCosts.h"

namespace velum::growth {

/// To which kind of seeds a voxel of a region belongs; Nobody: no seed reaches it.
enum class Owner : std::uint8_t { Nobody, Own, Others };

/// Divides a region between its own seeds and those of others: each voxel goes to the kind of seeds from which the
/// cheapest path leads to it, to its own seeds where both paths cost the same ([IFT]: a forest of shortest paths, by
/// buckets as in [DIAL]). Voxels that no seed reaches are Nobody's. Every voxel of the own part is joined to an own
/// seed by faces through voxels of the own part. O(voxels), beside one bucket for each cost that a step may have. Five
/// bytes for each voxel of the box, and eight for each that waits in a bucket.
/// @param own, others  seeds, as places in the box of the costs; seeds outside the region are ignored
/// @return the owner of each place of the box @throw Cancelled
std::vector<Owner> divideRegion(const PassageCosts& costs, std::span<const std::size_t> own,
                                std::span<const std::size_t> others, Progress& progress);

}  // namespace velum::growth
