#pragma once
#include "core/Volume.h"

namespace velum::io {

/// The grid of the scan that labels belong to.
struct LabelGrid {
  glm::ivec3 dims{0};
  glm::dmat4 worldFromVoxel{1.0};
  LengthUnit unit = LengthUnit::Millimetre;
};

/// That of a volume: of its finest level, where it is streamed.
LabelGrid gridOf(const Volume& scan);

/// The file says nothing of where its voxels lie: no size, or one that is no more than a default, or the scan's, and
/// neither axes of the patient nor an origin.
bool hasNoPlace(const Volume& v, const LabelGrid& scan);

}  // namespace velum::io
