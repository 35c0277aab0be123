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

/// The values that a click means ([ACS] 4.2): those of the segment of the opacity curve that the material's middle at
/// the place lies in, or where that is hidden the place's own value, from one valley of the curve to the next. They
/// begin at the segment's foot, where the material becomes visible, so that what is pulled has no holes that the
/// picture does not have; lower where what lies beside is far away in value; higher where the segment shows what is
/// darker beside, too; and end before what is brighter where the place's material is a peak of the values around.
/// Where the curve hides the place's voxel, but the picture shows something there, as at the rim of a shell, the
/// nearest voxel that it shows is asked instead. Where it hides the place they are those of its noise, and end halfway
/// to what lies beside.
///
/// Differs: the paper takes the curve's segment as it is; where skin and bone are one segment bone would take its flesh
/// with it.
/// @param histograms  knows the layer's, or will
/// @return nothing outside the volume
std::optional<MaterialRange> materialRangeAt(const scene::VolumeLayer& layer, glm::dvec3 world,
                                             HistogramMemo& histograms);
/// The same, once.
std::optional<MaterialRange> materialRangeAt(const scene::VolumeLayer& layer, glm::dvec3 world);

/// The segment of a curve that a value lies in: from valley to valley. Nothing where it is hidden there.
/// @param range  of the data's values
std::optional<MaterialRange> segmentOf(const scene::TransferFunction& transfer, double value, glm::dvec2 range);

}  // namespace velum::session
