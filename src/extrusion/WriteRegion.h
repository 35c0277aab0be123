#pragma once
#include "velum/core/LabelVolume.h"
#include "velum/extrusion/RegionGrow.h"

namespace velum::extrusion {

/// What writeRegion() has changed.
struct Written {
  VoxelBox box;
  std::size_t voxels = 0;
};

/// Gives a label to all voxels of the rows in which a region has grown, brick by brick; other bricks stay shared.
Written writeRegion(const RegionGrow& region, const RegionGrow::Changed& changed, std::uint16_t id,
                    LabelVolume& labels);

}  // namespace velum::extrusion
