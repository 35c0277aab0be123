#pragma once
#include <glm/glm.hpp>

#include "scene/Lettering.h"
#include "scene/SceneFwd.h"
#include "vector/Drawing.h"

namespace velum::session {

/// Sizes and colours of the lettering of a picture of so many pixels.
class LetteringStyle {
 public:
  /// @param leastEm  of letters, pixels; 0: what can just be read
  LetteringStyle(const scene::Lettering& lettering, glm::ivec2 size, double leastEm = 0.0);

  /// Of letters, pixels. @param share  of the lettering's own size
  double em(double share = 1.0) const;
  double lineWidth() const;  ///< pixels
  vector::Font font() const;
  /// The colour of letters and lines before a ground: that of the lettering, else dark on light and light on dark.
  glm::vec3 inkOn(glm::vec3 ground) const;
  /// The glow of letters of a colour: the ground, or where they would hardly be seen before it, its opposite.
  static glm::vec3 glowOf(glm::vec3 ink, glm::vec3 ground);

 private:
  const scene::Lettering& mLettering;
  glm::dvec2 mSize;
  double mLeastEm;
};

/// Column and row of a place, 0..2: left, middle, right; top, middle, bottom.
inline glm::ivec2 cellOf(scene::CaptionPlace place) { return {int(place) % 3, int(place) / 3}; }

/// The colour before which things stand at a place of a picture of a scene: its paper or background.
glm::vec3 groundOf(const scene::Scene& scene, scene::CaptionPlace place);

}  // namespace velum::session
