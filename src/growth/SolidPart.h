#pragma once
#include <cstddef>
#include <glm/glm.hpp>

#include "growth/GrowDomain.h"
#include "growth/RegionGrow.h"

namespace velum::growth {

/// How many voxels of a region in a slab are the inside of something solid: those that are left when the region is
/// eroded by the six neighbours, then by all 26. Threads, shells and struts of up to four voxels have no such voxels.
/// @param dims  of the region's volume
/// @param known  where the region has grown: voxels outside of it, or outside the volume, do not count as empty and
/// erode nothing
/// @param slab  the slab, which lies in `known`
std::size_t countSolid(const RegionGrow& region, glm::ivec3 dims, const GrowDomain& known, const GrowDomain& slab);

}  // namespace velum::growth
