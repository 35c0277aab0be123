#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace velum {

/// The direction of @p v with length 1, or @p fallback when @p v has no direction: it is shorter than 1e-12, infinite
/// or not a number.
inline glm::dvec3 unitOr(glm::dvec3 v, glm::dvec3 fallback) {
  double length = glm::length(v);
  return length > 1e-12 && std::isfinite(length) ? v / length : fallback;
}

/// Distance from the point @p p to the segment from @p a to @p b; @p a and @p b may be the same point.
inline double distanceToSegment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
  glm::dvec2 ab = b - a;
  double length2 = glm::dot(ab, ab);
  double t = length2 > 0 ? std::clamp(glm::dot(p - a, ab) / length2, 0.0, 1.0) : 0.0;
  return glm::length(p - a - ab * t);
}

/// The edges of a box made long enough for a solid: none is shorter than a hundred-millionth of the longest; all are 1
/// where all were 0.
inline glm::dvec3 solidEdges(glm::dvec3 edges) {
  double longest = std::max(edges.x, std::max(edges.y, edges.z));
  return glm::max(edges, glm::dvec3(longest > 0.0 ? 1e-8 * longest : 1.0));
}

}  // namespace velum
