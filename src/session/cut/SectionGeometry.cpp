#include "SectionGeometry.h"

#include <algorithm>
#include <cmath>

#include "velum/session/cut/CutEdit.h"

namespace velum::session {

glm::dvec2 onScreen(const scene::SectionPlane& plane, glm::dvec3 direction) {
  return {glm::dot(direction, plane.right), -glm::dot(direction, plane.up)};
}

std::optional<std::pair<glm::dvec2, glm::dvec2>> clipLine(glm::dvec2 p, glm::dvec2 d, glm::dvec2 low, glm::dvec2 high) {
  double t0 = -1e30, t1 = 1e30;
  for (int i = 0; i < 2; ++i) {
    if (std::abs(d[i]) < 1e-12) {
      if (p[i] < low[i] || p[i] > high[i]) return std::nullopt;
      continue;
    }
    double a = (low[i] - p[i]) / d[i], b = (high[i] - p[i]) / d[i];
    t0 = std::max(t0, std::min(a, b));
    t1 = std::min(t1, std::max(a, b));
  }
  if (t0 >= t1) return std::nullopt;
  return std::pair(p + d * t0, p + d * t1);
}

std::optional<PlaneLine> planeLine(const scene::SectionPlane& plane, const scene::Cut& cut) {
  glm::dvec3 n = cutFrame(cut)[2] * (cut.invert ? -1.0 : 1.0);
  glm::dvec2 m = onScreen(plane, n);
  double slant = glm::length(m);
  if (slant < 1e-6) return std::nullopt;
  glm::dvec2 across = m / slant;
  // How far the plane lies from the view's middle, along the screen.
  double mm = glm::dot(cut.centre - plane.centre, n) / slant;
  glm::dvec2 point = plane.size * 0.5 + across * (mm / plane.lengthPerPixel);
  return PlaneLine{point, {-across.y, across.x}, across};
}

}  // namespace velum::session
