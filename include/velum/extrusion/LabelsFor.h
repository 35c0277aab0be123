#pragma once
#include "velum/core/LabelVolume.h"
#include "velum/core/Shared.h"
#include "velum/core/Volume.h"

namespace velum::extrusion {

/// The labels in which a volume's structures grow: what is given where it lies on the volume's grid; brought there by
/// the nearest voxel, with a warning, where it does not; none where nothing is given.
Shared<LabelVolume> labelsFor(const Volume& volume, const Shared<LabelVolume>& given);

}  // namespace velum::extrusion
