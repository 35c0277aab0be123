#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "scene/Cut.h"
#include "scene/SectionPlane.h"

namespace velum::session {

/// Signed distance of a place in the world to the surface of a cut's shape that is no membrane, < 0 inside: the same as
/// shaders/shared/cut.h computes.
double shapeDistance(const scene::Cut& cut, glm::dvec3 world);

/// Where a section crosses the surface of any shape that has a distance, in the view and a little around the view.
/// Pixels; closed curves end where they begin.
std::vector<std::vector<glm::dvec2>> shapeContour(const scene::SectionPlane& plane, const scene::Cut& cut);

}  // namespace velum::session
