#pragma once
#include <glm/glm.hpp>
#include <optional>

#include "scene/SceneFwd.h"
#include "session/look/ShowThis.h"

namespace velum::session {

/// The material at a place where noise hides the materials beside it from a look at single voxels: as it is in the data
/// with the noise taken out (membrane::denoise()). The borders of the brightest material of the data, and of the
/// darkest, lie where this data is steepest, whichever place of the material is pointed at. Nothing where noise hides
/// nothing, outside the volume and in colours. A tenth of a second.
std::optional<Tissue> measureTissueInNoise(const scene::VolumeLayer& layer, glm::dvec3 world);

}  // namespace velum::session
