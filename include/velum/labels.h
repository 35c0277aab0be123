#pragma once
#include "core/LabelVolume.h"
#include "io/labels/ReadLabels.h"
#include "io/labels/WriteLabels.h"
#include "scene/Source.h"

/// LabelVolume: which structure each voxel belongs to. Also reads and writes files of labels.
namespace velum {

using io::readLabels;
using io::writeLabels;
using scene::Source;

}  // namespace velum
