#pragma once
#include <span>

#include "core/Model.h"

namespace velum::io {

/// How well the copies of a molecule on a compartment's surface agree on which of their own directions points away from
/// the compartment's middle: 1 where all copies stand on the surface in the same way, near 0 where their rotations are
/// misread.
/// @param instances  of one type
/// @param isInverse  use the inverse of each rotation
double outwardAgreement(std::span<const Instance> instances, glm::vec3 middle, bool isInverse);

}  // namespace velum::io
