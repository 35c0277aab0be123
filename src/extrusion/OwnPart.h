#pragma once
#include <optional>

#include "BitGrid.h"
#include "velum/core/LabelVolume.h"
#include "velum/core/Shared.h"
#include "velum/core/Task.h"
#include "velum/core/Volume.h"
#include "velum/extrusion/GrowDomain.h"
#include "velum/extrusion/Grower.h"
#include "velum/extrusion/RegionGrow.h"
#include "velum/scene/Growth.h"

namespace velum::extrusion {

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

}  // namespace velum::extrusion
