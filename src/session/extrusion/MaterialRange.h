#pragma once
#include <glm/glm.hpp>
#include <optional>

#include "scene/SceneFwd.h"
#include "scene/TransferFunction.h"
#include "session/look/ValueHistogram.h"

namespace velum::session {

/// The values that belong to one material, both ends included, the volume's unit.
struct MaterialRange {
  double low = 0.0, high = 0.0;
};

/// The values that a click on a place means ([ACS] 4.2). They are those of the segment of the opacity curve, from one
/// valley of the curve to the next, in which the middle of the material at the place lies, or, where the curve hides
/// that middle, the place's own value. They begin at the segment's foot, where the material becomes visible, so that
/// what is pulled has no holes that the picture does not have. They begin lower where the material beside is far away
/// in value, and higher where the segment also shows a darker material beside; they end before a brighter material
/// where the place's material is a peak of the values around. Where the curve hides the place's voxel but the picture
/// shows something there, as at the rim of a shell, the nearest voxel that the curve shows is asked instead. Where the
/// curve hides the place altogether, the values are those of the place's noise, and end halfway to the material beside.
///
/// Differs: the paper takes the curve's segment as it is; where skin and bone are one segment bone would take its flesh
/// with it.
///
/// Of a volume that is streamed the voxels of its finest level around the place count; where these cannot be read,
/// those in memory.
/// @param histograms  holds the layer's histogram, or counts it
/// @return nothing outside the volume
std::optional<MaterialRange> materialRangeAt(const scene::VolumeLayer& layer, glm::dvec3 world,
                                             HistogramMemo& histograms);
/// The same for a single call, with the histogram counted anew.
std::optional<MaterialRange> materialRangeAt(const scene::VolumeLayer& layer, glm::dvec3 world);

/// True when materialRangeAt() there, and a pull that begins there, would wait for no disk. Any thread.
bool isInMemoryAround(const scene::VolumeLayer& layer, glm::dvec3 world);
/// Brings there what they look at, as far as it can be read. Any thread but the window's.
void bringAround(const scene::VolumeLayer& layer, glm::dvec3 world);

/// The segment of a curve that a value lies in: from valley to valley. Nothing where the curve hides the value.
/// @param range  of the data's values
std::optional<MaterialRange> segmentOf(const scene::TransferFunction& transfer, double value, glm::dvec2 range);

}  // namespace velum::session
