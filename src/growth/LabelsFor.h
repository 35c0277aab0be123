#pragma once
#include "core/LabelVolume.h"
#include "core/Shared.h"
#include "core/Volume.h"

namespace velum::growth {

/// The labels into which a volume's structures grow, on the grid of its finest level: the labels `given` where they lie
/// on that grid; else
/// `given` brought onto that grid by the nearest voxel, with a warning; empty labels where none are given.
Shared<LabelVolume> labelsFor(const Volume& volume, const Shared<LabelVolume>& given);

}  // namespace velum::growth
