#pragma once
#include <cstdint>
#include <functional>

#include "core/LabelVolume.h"
#include "growth/RegionGrow.h"

namespace velum::growth {

/// What writeRegion() has changed.
struct Written {
  VoxelBox box;
  std::size_t voxels = 0;
};

/// The bits of a row of a region.
using RegionRow = std::function<const std::uint64_t*(int y, int z)>;

/// Gives a label to all voxels of the rows in which a region has grown, brick by brick; other bricks stay shared.
Written writeRegion(const RegionRow& region, const RegionGrow::Changed& changed, std::uint16_t id, LabelVolume& labels);

}  // namespace velum::growth
