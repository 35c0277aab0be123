#pragma once
#include <span>
#include <vector>

#include "membrane/forces/PushField.h"
#include "scene/Cut.h"

namespace velum::membrane {

/// Which particles the pins of a membrane hold, and in which places. By the sided rule particles move along the normal
/// only: the corners of the mesh cell over which a pin stands are held at the pin's height, so that the sheet passes
/// through the pin exactly, whatever the sheet's resolution. By the paper's rule the particle that a pin names is held
/// in its place.
/// @param places  where the particles of the sheet are now, frame-local
std::vector<HeldParticle> heldByPins(const scene::Cut& cut, glm::ivec2 particles, std::span<const glm::vec3> places);

/// Differs: not in the paper. By the sided rule the pull back to the rest plane is strong, so that a pin alone would
/// raise a needle: the sheet is pulled to a smooth surface through all pins instead, which falls back to the rest plane
/// around them (an interpolation with the positive definite function of [WENDLAND], of one radius for all). O(pins^3).
std::vector<PlacedKernel> liftsByPins(const scene::Cut& cut);

}  // namespace velum::membrane
