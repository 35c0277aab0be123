#pragma once
#include <glm/glm.hpp>

#include "velum/scene/Scene.h"

namespace velum::render {

/// What is to be drawn. A value: the same frame gives the same picture, and a changed one starts it anew.
struct Frame {
  scene::Scene scene;
  glm::ivec2 pictureSize{0};   ///< The whole picture, pixels.
  glm::ivec2 windowOrigin{0};  ///< Top left corner of the part that is drawn, pixels of the whole.
  glm::ivec2 windowSize{0};    ///< Size of that part; {0,0}: all of it.
  double stepFactor = 1.0;     ///< Coarse pictures take longer steps, >= 1.
  /// A picture at once, for while something moves: shadows and occlusion as they stand in the last full frame of the
  /// same material, or none; a smaller copy of a volume that is not on the GPU yet.
  bool isPreview = false;
  bool operator==(const Frame&) const = default;
};

}  // namespace velum::render
