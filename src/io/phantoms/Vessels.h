#pragma once
#include "io/phantoms/Tree.h"

/// A kidney-like organ and its vessels, millimetres.
namespace velum::io::phantom {

/// Distance to the organ, below 0 inside: an ellipsoid with a shallow dent where the vessels enter.
float vesselOrgan(Vec p);
/// A tree of vessels that fills it. @param pitchMm  between places that it feeds
Tree growVessels(Vec root, float rootRadiusMm, float leastRadiusMm, float pitchMm, std::uint64_t seed);

}  // namespace velum::io::phantom
