#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <utility>

#include "scene/Cut.h"
#include "scene/SectionPlane.h"

/// Lines in the plane of a section. In its pixels.
namespace velum::session {

/// A plane's line on a section, pixels.
struct PlaneLine {
  glm::dvec2 point, along, across;  ///< along and across: unit; across: to where it takes away
};
/// Nothing when the plane lies along the section.
std::optional<PlaneLine> planeLine(const scene::SectionPlane& plane, const scene::Cut& cut);

/// Screen direction of a world direction; zero length when it stands across the section.
glm::dvec2 onScreen(const scene::SectionPlane& plane, glm::dvec3 direction);

/// The part of the line p + t d inside the rectangle from low to high.
std::optional<std::pair<glm::dvec2, glm::dvec2>> clipLine(glm::dvec2 p, glm::dvec2 d, glm::dvec2 low, glm::dvec2 high);

}  // namespace velum::session
