#include "session/cut/SectionGeometry.h"

#include <algorithm>
#include <cmath>

#include "session/cut/CutEdit.h"

namespace velum::session {

glm::dvec2 onScreen(const scene::SectionPlane& plane, glm::dvec3 direction) {
  return {glm::dot(direction, plane.right), -glm::dot(direction, plane.up)};
}

std::optional<std::pair<glm::dvec2, glm::dvec2>> clipLine(glm::dvec2 p, glm::dvec2 d, glm::dvec2 low, glm::dvec2 high) {
  auto stretch = scene::stretchIn(p, d, low, high);
  if (!stretch) return std::nullopt;
  return std::pair(p + d * stretch->x, p + d * stretch->y);
}

std::optional<PlaneLine> planeLine(const scene::SectionPlane& plane, const scene::Cut& cut) {
  glm::dvec3 n = cutFrame(cut)[2] * (cut.invert ? -1.0 : 1.0);
  glm::dvec2 m = onScreen(plane, n);
  double slant = glm::length(m);
  if (slant < 1e-6) return std::nullopt;
  glm::dvec2 across = m / slant;
  // How far the plane lies from the view's middle, along the screen.
  double length = glm::dot(cut.centre - plane.centre, n) / slant;
  glm::dvec2 point = plane.size * 0.5 + across * (length / plane.lengthPerPixel);
  return PlaneLine{point, {-across.y, across.x}, across};
}

}  // namespace velum::session
