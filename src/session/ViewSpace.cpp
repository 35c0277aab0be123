#include "velum/session/ViewSpace.h"

#include <algorithm>
#include <cmath>

#include "velum/scene/Project.h"

namespace velum::session {

std::optional<glm::dvec2> ViewSpace::pixelFromWorld(glm::dvec3 worldMm) const {
  if (mSection) return scene::slicePixelFromWorld(*mSection, worldMm);
  return scene::pixelFromWorld(mCamera, mSize, worldMm);
}

double ViewSpace::mmPerPixel(glm::dvec3 worldMm) const {
  return mSection ? mSection->mmPerPixel : scene::mmPerPixel(mCamera, mSize, worldMm);
}

std::optional<ViewCircle> ViewSpace::circleOfBall(glm::dvec3 middleMm, double radiusMm) const {
  if (mSection) {
    double height = scene::heightOverSlice(*mSection, middleMm);
    if (std::abs(height) >= radiusMm) return std::nullopt;
    return ViewCircle{scene::slicePixelFromWorld(*mSection, middleMm),
                      std::sqrt(radiusMm * radiusMm - height * height) / mSection->mmPerPixel};
  }
  auto place = scene::pixelFromWorld(mCamera, mSize, middleMm);
  if (!place) return std::nullopt;
  return ViewCircle{*place, radiusMm / std::max(1e-12, scene::mmPerPixel(mCamera, mSize, middleMm))};
}

}  // namespace velum::session
