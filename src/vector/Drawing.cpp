#include "vector/Drawing.h"

#include <cmath>

#include "core/Assert.h"

namespace velum::vector {

namespace {
constexpr double kArm = 0.5522847498307936;  // a quarter of a circle within 0.03 % of its radius
}

bool isStraight(glm::dvec2 from, const Curve& curve) {
  glm::dvec2 chord = curve.end - from;
  double length = glm::length(chord), most = 1e-9 * (1.0 + length);
  auto isOn = [&](glm::dvec2 point) {
    glm::dvec2 way = point - from;
    return std::abs(way.x * chord.y - way.y * chord.x) <= most * std::max(length, 1.0) &&
           glm::dot(way, chord) >= -most && glm::dot(way, chord) <= length * length + most;
  };
  return isOn(curve.control1) && isOn(curve.control2);
}

std::string_view groupOf(const Item& item) {
  const auto* shape = std::get_if<Shape>(&item);
  return shape ? std::string_view(shape->group) : std::string_view();
}

Outline outlineThrough(const std::vector<glm::dvec2>& points, bool isClosed) {
  VELUM_ASSERT(!points.empty(), "a line goes through a point");
  Outline out{points.front(), {}, isClosed};
  for (std::size_t i = 1; i < points.size(); ++i) out.curves.push_back(straight(points[i - 1], points[i]));
  if (isClosed && points.size() > 1) out.curves.push_back(straight(points.back(), points.front()));
  return out;
}

Outline circle(glm::dvec2 middle, double radius) {
  Outline out{middle + glm::dvec2(radius, 0.0), {}, true};
  glm::dvec2 x(radius, 0.0), y(0.0, radius);
  for (int quarter = 0; quarter < 4; ++quarter) {
    out.curves.push_back({middle + x + kArm * y, middle + y + kArm * x, middle + y});
    glm::dvec2 next = -x;
    x = y;
    y = next;
  }
  return out;
}

Outline rectangle(glm::dvec2 low, glm::dvec2 high, double left, double right) {
  Outline out{{low.x + left, low.y}, {}, true};
  glm::dvec2 at = out.start;
  auto side = [&](glm::dvec2 to) {
    if (to != at) out.curves.push_back(straight(at, to));
    at = to;
  };
  auto turn = [&](glm::dvec2 corner, glm::dvec2 to) {
    if (to != at) out.curves.push_back({glm::mix(at, corner, kArm), glm::mix(to, corner, kArm), to});
    at = to;
  };
  side({high.x - right, low.y});
  turn({high.x, low.y}, {high.x, low.y + right});
  side({high.x, high.y - right});
  turn(high, {high.x - right, high.y});
  side({low.x + left, high.y});
  turn({low.x, high.y}, {low.x, high.y - left});
  side({low.x, low.y + left});
  turn(low, out.start);
  return out;
}

}  // namespace velum::vector
