#pragma once
#include <glm/glm.hpp>

#include "scene/Scene.h"

namespace velum::bench {

/// Trilinear fetches that a plain ray caster needs for a frame: skips every empty cell of 4^3 voxels without asking
/// anything of the volume, stops at opacity, takes six fetches for the gradient of each sample that shows.
struct FetchCount {
  double samples = 0;    ///< Fetches of values, millions.
  double gradients = 0;  ///< Fetches of gradients, millions.
};

/// Counted on the processor for every 16th ray and multiplied. @param scene  an axis-aligned volume; no cuts, no labels
FetchCount countFetches(const scene::Scene& scene, glm::ivec2 size);

}  // namespace velum::bench
