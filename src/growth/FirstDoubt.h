#pragma once
#include "core/LabelVolume.h"
#include "core/Shared.h"
#include "core/Volume.h"
#include "scene/Growth.h"

namespace velum::growth {

/// Signs, checked before a structure grows from a click (not from typed values), that what would grow is hardly what
/// the user meant.
///
/// True when the step's range of values reaches down to the least values of the data, as the surroundings of every
/// object (air) do. The lowest hundredth of the data's values counts as the least, so that the circle around a scan
/// does not hide its air. Of a volume that is streamed, the values of its coarse level. O(voxels in memory).
bool reachesTheDarkest(const Volume& volume, const scene::Growth& step);

/// The depth up to which a step is looked at: where the first slab that holds some of the data ends.
double firstSlabEnd(const Volume& volume, const scene::Growth& step);

/// True when the structure is most of what the first slab behind the step's plane holds: more than three tenths of the
/// slab's voxels, and more than three fifths of the voxels brighter than halfway from the data's least value to the
/// step's lowest.
/// Of a volume that is streamed, values of its coarse level count, and of the slab's voxels some.
/// @param labels  with the structure grown so far, up to the step's distance
bool isMostOfItsPlane(const Volume& volume, const LabelVolume& labels, const scene::Growth& step);

}  // namespace velum::growth
