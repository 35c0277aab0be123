#include "session/section/SectionTool.h"

#include <algorithm>
#include <cmath>

namespace velum::session {

namespace {

// Tried at 300 to 900 pixels: knobs that can be held and do not hide letters at the sides.
constexpr double kKnobInset = 46.0, kLeastArm = 34.0;
/// Pixels for e times the width; for one width of level.
constexpr double kWidthPixels = 220.0, kLevelPixels = 300.0;

}  // namespace

std::vector<CrosshairLine> crosshairLines(const scene::Scene& scene, scene::SectionKind kind,
                                          const scene::SectionPlane& plane) {
  std::vector<CrosshairLine> lines;
  glm::dvec2 cross = scene::sectionPixelFromWorld(plane, scene.sections.crosshair);
  for (auto other : {scene::SectionKind::Axial, scene::SectionKind::Coronal, scene::SectionKind::Sagittal}) {
    if (other == kind) continue;
    glm::dvec3 normal = scene::makeSectionPlane(scene, other, glm::dvec2(1.0)).normal;
    glm::dvec3 direction = glm::cross(plane.normal, normal);
    glm::dvec2 along(glm::dot(direction, plane.right), -glm::dot(direction, plane.up));
    if (glm::length(along) < 1e-6) continue;
    along = glm::normalize(along);
    auto whole = scene::stretchIn(cross, along, glm::dvec2(0.0), plane.size);
    if (!whole) continue;
    CrosshairLine line;
    line.other = other;
    line.from = cross + along * whole->x;
    line.to = cross + along * whole->y;
    auto inner = scene::stretchIn(cross, along, glm::dvec2(kKnobInset), plane.size - kKnobInset);
    if (inner && inner->x < -kLeastArm && inner->y > kLeastArm) {
      line.hasKnobs = true;
      line.knobs[0] = cross + along * inner->x;
      line.knobs[1] = cross + along * inner->y;
    }
    lines.push_back(line);
  }
  return lines;
}

bool isOnKnob(const std::vector<CrosshairLine>& lines, glm::dvec2 pixel, double reach) {
  for (const auto& line : lines)
    for (const auto& knob : line.knobs)
      if (line.hasKnobs && glm::length(knob - pixel) <= reach) return true;
  return false;
}

scene::Sections turnedSections(const scene::Scene& start, scene::SectionKind kind, const scene::SectionPlane& plane,
                               glm::dvec2 from, glm::dvec2 to) {
  glm::dvec2 cross = scene::sectionPixelFromWorld(plane, start.sections.crosshair);
  // Rows run downwards: this counts anticlockwise, as a turn about the normal does for who sees it from its tip.
  auto angle = [&](glm::dvec2 p) { return std::atan2(cross.y - p.y, p.x - cross.x); };
  scene::Scene turned = start;
  scene::turnSections(turned, kind, angle(to) - angle(from));
  return turned.sections;
}

glm::dvec2 draggedWindow(glm::dvec2 start, glm::dvec2 drag) {
  return {start.x + drag.y / kLevelPixels * start.y, start.y * std::exp(drag.x / kWidthPixels)};
}

double rulerLength(double most) {
  double decade = std::pow(10.0, std::floor(std::log10(most)));
  for (double factor : {5.0, 2.0})
    if (factor * decade <= most) return factor * decade;
  return decade;
}

}  // namespace velum::session
