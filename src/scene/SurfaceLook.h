#pragma once
#include "core/Volume.h"
#include "scene/SceneFwd.h"
#include "scene/TransferFunction.h"

namespace velum::scene {

/// True when most of what a look shows lets one see what is behind: a veil of skin over bone, a haze. Lines of a finish
/// then lie on whatever a ray happens to be half lost in. @param histogram  of the values that it shows
bool isTranslucent(const TransferFunction& transfer, const Histogram& histogram);

/// Makes the look of the volume, of all channels that are mixed, one of surfaces: what was nearly opaque, or the most
/// so of what was a haze, is opaque within a voxel, and the veils before it are clear. Colours stay.
void makeSurface(Scene& scene);

}  // namespace velum::scene
