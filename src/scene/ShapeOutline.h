#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "scene/Cut.h"

namespace velum::scene {

/// A closed line; one of two points is a straight piece. Frame of the cut.
using ShapeLine = std::vector<glm::dvec3>;

/// How finely round shapes are drawn.
struct OutlineDetail {
  int corners = 64;  ///< of a circle
  int sides = 4;     ///< lines from one rim to the other
};

/// The lines by which a cut's shape is drawn: edges of a box, rims and sides of a round shape, a membrane's rest plane.
/// @return  none for a plane, which ends where the data does
std::vector<ShapeLine> shapeOutline(const Cut& cut, OutlineDetail detail);

}  // namespace velum::scene
