#pragma once
#include <optional>

#include "core/LabelVolume.h"
#include "core/Shared.h"
#include "core/Task.h"
#include "core/Volume.h"
#include "growth/BoxBits.h"
#include "growth/GrowDomain.h"
#include "growth/Grower.h"
#include "growth/RegionGrow.h"
#include "scene/Growth.h"

namespace velum::growth {

/// A region divided between a step's seeds and its others: the part that is the structure's own.
struct OwnPart {
  BoxBits own;
  Shared<LabelVolume> others;  ///< label 1 on the voxels that went to the others
};

/// Divides the region that a step would take without its others, see divideRegion(). Own seeds are the step's seeds,
/// the voxels that the structure had before, and those in GrowOptions::begun. Where the step begins at two regions, its
/// own and that of the others (as at another time step), the voxels along the border between the two are decided anew.
/// @param region  grown to its end in the domain, as if there were no others
/// @return nothing where none of the others lies in the region: then the whole region is the structure's own
/// @throw Cancelled; InputError when a brick cannot be read, or the region reaches too far for the memory
std::optional<OwnPart> ownPartOf(const RegionGrow& region, const Volume& volume, const LabelVolume& before,
                                 const scene::Growth& step, const GrowDomain& domain, const GrowOptions& options,
                                 Progress& progress);

}  // namespace velum::growth
