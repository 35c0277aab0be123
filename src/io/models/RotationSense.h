#pragma once
#include <span>

#include "core/Model.h"

namespace velum::io {

/// How much alike the directions away from the middle of a compartment are in the frames of its surface's molecules: 1
/// where all copies stand on the surface in the same way, near 0 where their rotations are misread.
/// @param instances  of one type
/// @param isInverse  take each rotation the other way round
double outwardAgreement(std::span<const Instance> instances, glm::vec3 middle, bool isInverse);

}  // namespace velum::io
