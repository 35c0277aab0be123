#pragma once
#include "core/LabelVolume.h"
#include "core/Shared.h"
#include "core/Volume.h"

namespace velum::growth {

/// The labels in which a volume's structures grow: what is given where it lies on the volume's grid; brought there by
/// the nearest voxel, with a warning, where it does not; none where nothing is given.
Shared<LabelVolume> labelsFor(const Volume& volume, const Shared<LabelVolume>& given);

}  // namespace velum::growth
