#pragma once
#include <span>

#include "core/Volume.h"
#include "scene/Membrane.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// How often each value occurs under strokes of one kind: of all voxels whose middles lie within the radius of a path,
/// each once however many strokes pass it. A stroke thinner than voxels takes those that it goes through. Of the
/// layer's channel and time step. O(voxels under the strokes). Any thread.
/// @param avoid  of which strokes
/// @param like   whose bins and range it has: valueHistogram() of the layer
Histogram strokeHistogram(const scene::VolumeLayer& layer, std::span<const scene::Stroke> strokes, bool avoid,
                          const Histogram& like);

/// The same for volumes that nobody has counted yet; O(voxels) up to 16 million.
Histogram wholeHistogram(const scene::VolumeLayer& layer);

}  // namespace velum::session
