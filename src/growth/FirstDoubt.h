#pragma once
#include "core/LabelVolume.h"
#include "core/Shared.h"
#include "core/Volume.h"
#include "scene/Growth.h"

namespace velum::growth {

/// Before a structure grows that somebody has clicked on, not typed: what makes it unlikely that it is meant.
///
/// The values reach the least of the data, as those of what is around everything do. Of the data's values a hundredth
/// counts as the least, so that a scan's circle does not hide its air. O(voxels).
bool reachesTheDarkest(const Volume& volume, const scene::Growth& step);

/// Up to which depth a step is looked at: the end of the first slab that has something of the data.
double firstSlabEnd(const Volume& volume, const scene::Growth& step);

/// It is most of what there is before its plane, from the first slab on: of the data's box a good part, and more than
/// three fifths of what is brighter than halfway from the data's least value to the step's.
/// @param labels  with the structure grown so far, up to the step's distance
bool isMostOfItsPlane(const Volume& volume, const LabelVolume& labels, const scene::Growth& step);

}  // namespace velum::growth
