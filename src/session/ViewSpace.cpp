#include "session/ViewSpace.h"

#include <algorithm>
#include <cmath>

#include "scene/Project.h"

namespace velum::session {

std::optional<glm::dvec2> ViewSpace::pixelFromWorld(glm::dvec3 world) const {
  if (mSection) return scene::sectionPixelFromWorld(*mSection, world);
  return scene::pixelFromWorld(mCamera, mSize, world);
}

double ViewSpace::lengthPerPixel(glm::dvec3 world) const {
  return mSection ? mSection->lengthPerPixel : scene::lengthPerPixel(mCamera, mSize, world);
}

std::optional<ViewCircle> ViewSpace::circleOfBall(glm::dvec3 middle, double radius) const {
  if (mSection) {
    double height = scene::heightOverSection(*mSection, middle);
    if (std::abs(height) >= radius) return std::nullopt;
    return ViewCircle{scene::sectionPixelFromWorld(*mSection, middle),
                      std::sqrt(radius * radius - height * height) / mSection->lengthPerPixel};
  }
  auto place = scene::pixelFromWorld(mCamera, mSize, middle);
  if (!place) return std::nullopt;
  return ViewCircle{*place, radius / std::max(1e-12, scene::lengthPerPixel(mCamera, mSize, middle))};
}

}  // namespace velum::session
