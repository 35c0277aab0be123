#pragma once
#include <glm/glm.hpp>
#include <optional>

#include "core/Volume.h"
#include "scene/Scene.h"

namespace velum::bench {

/// Where a hand would click: the place nearest to the middle of the volume where a voxel and its neighbours have values
/// in a range. World; nothing where there is none.
std::optional<glm::dvec3> clickPlace(const Volume& volume, double low, double high);

/// The frame that the window hangs into a scene's data: across a direction (world), at a share of the data's extent
/// along it. Protects nothing yet.
scene::Cut membraneAcross(const scene::Scene& scene, glm::dvec3 along, double share);

}  // namespace velum::bench
