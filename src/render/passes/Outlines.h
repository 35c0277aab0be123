#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "scene/SceneFwd.h"

namespace velum::render {

/// Line ends, in pairs, of the data's box and of each enabled cut. World frame.
/// @param worldFromTex  the box is 0..1
std::vector<glm::dvec3> outlines(const scene::Scene& scene, const glm::dmat4& worldFromTex);

}  // namespace velum::render
