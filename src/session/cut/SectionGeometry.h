#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <utility>

#include "scene/Cut.h"
#include "scene/SectionPlane.h"

/// Lines in the plane of a section, in pixels of the section.
namespace velum::session {

/// The line in which a plane crosses a section, pixels.
struct PlaneLine {
  glm::dvec2 point, along, across;  ///< along and across: unit; across points to the side that the cut removes
};
/// The line of a cut's plane on a section; nothing when the plane lies along the section.
std::optional<PlaneLine> planeLine(const scene::SectionPlane& plane, const scene::Cut& cut);

/// Direction on the screen of a direction in the world; zero length when that stands across the section.
glm::dvec2 onScreen(const scene::SectionPlane& plane, glm::dvec3 direction);

/// The part of the line p + t d inside the rectangle from low to high.
std::optional<std::pair<glm::dvec2, glm::dvec2>> clipLine(glm::dvec2 p, glm::dvec2 d, glm::dvec2 low, glm::dvec2 high);

}  // namespace velum::session
