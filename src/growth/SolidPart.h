#pragma once
#include <cstddef>
#include <glm/glm.hpp>

#include "growth/GrowDomain.h"
#include "growth/RegionGrow.h"

namespace velum::growth {

/// How many voxels of a region in a slab are the inside of something solid: those that are left when it is eroded by
/// the six neighbours, then by all 26. Threads, shells and struts of up to four voxels have none.
/// @param dims  of the region's volume
/// @param known  where the region has grown: what lies outside, or outside the volume, takes nothing away
/// @param slab  in `known`
std::size_t countSolid(const RegionGrow& region, glm::ivec3 dims, const GrowDomain& known, const GrowDomain& slab);

}  // namespace velum::growth
