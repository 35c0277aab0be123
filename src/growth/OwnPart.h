#pragma once
#include <optional>

#include "core/LabelVolume.h"
#include "core/Shared.h"
#include "core/Task.h"
#include "core/Volume.h"
#include "growth/BitGrid.h"
#include "growth/GrowDomain.h"
#include "growth/Grower.h"
#include "growth/RegionGrow.h"
#include "scene/Growth.h"

namespace velum::growth {

/// What is left of a region when it is divided between a step's seeds and its others.
struct OwnPart {
  BitGrid own;
  Shared<LabelVolume> others;  ///< 1 where it went to them
};

/// Divides what a step would take if nothing was said of others, see divideRegion(). Its own seeds are those of the
/// step, what the structure had before, and what it begins at. Of two regions that it begins at, as at another time
/// step, what lies along the border between them is decided anew.
/// @param region  grown whole in the domain
/// @return nothing where none of the others lies in the region: then all of it is its own
/// @throw Cancelled
std::optional<OwnPart> ownPartOf(const RegionGrow& region, const Volume& volume, const LabelVolume& before,
                                 const scene::Growth& step, const GrowDomain& domain, const GrowOptions& options,
                                 Progress& progress);

}  // namespace velum::growth
