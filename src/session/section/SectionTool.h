#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "scene/SectionPlane.h"

namespace velum::session {

/// The line in which another section crosses this one: it goes through the crosshair and is clipped to the view. Pixels
/// of the section's frame.
struct CrosshairLine {
  scene::SectionKind other = scene::SectionKind::Axial;
  glm::dvec2 from{0.0}, to{0.0};
  glm::dvec2 knobs[2];    ///< near the line's ends: dragging a knob turns both other sections
  bool hasKnobs = false;  ///< false where the crosshair lies out of the view or the view is small
};
std::vector<CrosshairLine> crosshairLines(const scene::Scene& scene, scene::SectionKind kind,
                                          const scene::SectionPlane& plane);

/// True when a knob is within reach of a pixel. @param reach  pixels
bool isOnKnob(const std::vector<CrosshairLine>& lines, glm::dvec2 pixel, double reach);

/// The sections after a knob was dragged about the crosshair, made from the sections as they were when the drag began.
scene::Sections turnedSections(const scene::Scene& start, scene::SectionKind kind, const scene::SectionPlane& plane,
                               glm::dvec2 from, glm::dvec2 to);

/// The grey window after a drag: a drag to the right makes the window wider, a drag down makes the picture darker.
/// Level and width, the volume's unit.
/// @param start  level and width when the drag began  @param drag  pixels
glm::dvec2 draggedWindow(glm::dvec2 start, glm::dvec2 drag);

/// A round length for a scale bar. @param most  the longest that the bar may be, > 0
double rulerLength(double most);

}  // namespace velum::session
