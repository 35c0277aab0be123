#pragma once
#include <cstdint>
#include <functional>

#include "core/LabelVolume.h"
#include "growth/RegionGrow.h"

namespace velum::growth {

/// What writeRegion() has changed: the box around the voxels, and how many there are.
struct Written {
  VoxelBox box;
  std::size_t voxels = 0;
};

/// A word of the bits of a region's row.
using RegionWord = std::function<std::uint64_t(int y, int z, int word)>;

/// Gives a label to the region's voxels in the rows that have grown, brick by brick; the other bricks stay shared.
Written writeRegion(const RegionWord& region, const RegionGrow::Changed& changed, std::uint16_t id,
                    LabelVolume& labels);

}  // namespace velum::growth
