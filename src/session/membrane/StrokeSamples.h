#pragma once
#include <span>

#include "core/Volume.h"
#include "scene/Membrane.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// How often each value occurs under strokes of one kind: counts the voxels whose middles lie within the radius of a
/// stroke's path, each voxel once however many strokes pass it. A stroke thinner than voxels takes those that it goes
/// through. Of the layer's channel and time step. O(voxels under the strokes). Any thread.
/// @param avoid  true: the strokes that avoid; false: the strokes that keep
/// @param like   valueHistogram() of the layer: the result has its bins and range
Histogram strokeHistogram(const scene::VolumeLayer& layer, std::span<const scene::Stroke> strokes, bool avoid,
                          const Histogram& like);

/// The same for the whole volume, where nobody has counted it yet; O(voxels) up to 16 million.
Histogram wholeHistogram(const scene::VolumeLayer& layer);

}  // namespace velum::session
