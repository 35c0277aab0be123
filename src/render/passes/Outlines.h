#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "scene/SceneFwd.h"

namespace velum::render {

/// The outlines of the data's box and of each enabled cut, as lines: pairs of ends. World frame.
/// @param worldFromTex  the data's box is 0..1 in its texture coordinates
std::vector<glm::dvec3> outlines(const scene::Scene& scene, const glm::dmat4& worldFromTex);

}  // namespace velum::render
