#pragma once
#include "vector/TraceSteps.h"

namespace velum::vector {

/// A pixel as the finish sees it: shaders/render/sample.glsl.
struct SeenPixel {
  glm::vec2 normal{0.0f};  ///< as the eye sees it: to the right, up; unit with its third part, which is towards the eye
  float depth = 0.0f;      ///< perspective: one over the distance along the line of sight; orthographic: that distance
  int id = 0;              ///< 0: nothing
};

/// All pixels. Any thread, on all cores.
std::vector<SeenPixel> seenPixels(const SurfaceMap& map, const View& view);

}  // namespace velum::vector
