#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "scene/SectionPlane.h"

namespace velum::session {

/// Where another section crosses this one: a line through the crosshair, clipped to the view. Pixels of the frame.
struct CrosshairLine {
  scene::SectionKind other = scene::SectionKind::Axial;
  glm::dvec2 from{0.0}, to{0.0};
  glm::dvec2 knobs[2];    ///< near its ends: dragging one turns both other sections
  bool hasKnobs = false;  ///< false where the crosshair is out of the view or the view is small
};
std::vector<CrosshairLine> crosshairLines(const scene::Scene& scene, scene::SectionKind kind,
                                          const scene::SectionPlane& plane);

/// True when a knob is within reach of a pixel.
bool isOnKnob(const std::vector<CrosshairLine>& lines, glm::dvec2 pixel, double reach);

/// The sections after a knob was dragged about the crosshair, from how they were when the drag began.
scene::Sections turnedSections(const scene::Scene& start, scene::SectionKind kind, const scene::SectionPlane& plane,
                               glm::dvec2 from, glm::dvec2 to);

/// The grey window after a drag: to the right is wider, down is darker. Level and width, the volume's unit.
/// @param drag  pixels
glm::dvec2 draggedWindow(glm::dvec2 start, glm::dvec2 drag);

/// A round length for a scale bar. @param most  that it may take at most, > 0
double rulerLength(double most);

}  // namespace velum::session
