#pragma once
#include "core/Volume.h"
#include "scene/SceneFwd.h"
#include "scene/TransferFunction.h"

namespace velum::scene {

/// True when most material that a look shows is translucent: a veil of skin over bone, a haze. Lines of a finish would
/// then lie wherever a ray happens to have lost half of its light. @param histogram  of the values that the look shows
bool isTranslucent(const TransferFunction& transfer, const Histogram& histogram);

/// Turns the look of the volume, or of all mixed channels, into one of surfaces: values that were nearly opaque (in a
/// haze, the most opaque ones) become opaque within a voxel, and the veils in front of them become clear. Colours stay.
void makeSurface(Scene& scene);

}  // namespace velum::scene
