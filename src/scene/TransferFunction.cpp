#include "scene/TransferFunction.h"

#include <algorithm>

namespace velum::scene {

namespace {

/// Interpolates a list of points by value; `get` picks the quantity.
template <class Point, class Get>
auto interpolate(const std::vector<Point>& points, double value, Get get) -> decltype(get(points[0])) {
  auto after =
      std::upper_bound(points.begin(), points.end(), value, [](double v, const Point& p) { return v < p.value; });
  if (after == points.begin()) return get(points.front());
  if (after == points.end()) return get(points.back());
  const Point& a = *(after - 1);
  const Point& b = *after;
  double f = (value - a.value) / (b.value - a.value);
  return get(a) * (1.0 - f) + get(b) * f;
}

}  // namespace

double opacityAt(const std::vector<OpacityPoint>& points, double value) {
  return points.empty() ? 0.0 : interpolate(points, value, [](const auto& p) { return p.opacity; });
}

glm::dvec3 colorAt(const std::vector<ColorPoint>& points, double value) {
  return points.empty() ? glm::dvec3(1.0)
                        : interpolate(points, value, [](const auto& p) { return glm::dvec3(p.color); });
}

}  // namespace velum::scene
