#include "scene/ShapeOutline.h"

#include <cmath>
#include <iterator>
#include <numbers>

namespace velum::scene {

namespace {

using Lines = std::vector<ShapeLine>;
constexpr glm::dvec2 kCorners[] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};

glm::dvec2 onCircle(int i, int corners) {
  double angle = 2.0 * std::numbers::pi * i / corners;
  return {std::cos(angle), std::sin(angle)};
}

/// @param x, y  from the middle to the circle
ShapeLine circle(glm::dvec3 middle, glm::dvec3 x, glm::dvec3 y, int corners) {
  ShapeLine line;
  for (int i = 0; i < corners; ++i) {
    glm::dvec2 at = onCircle(i, corners);
    line.push_back(middle + at.x * x + at.y * y);
  }
  return line;
}

/// A circle about the axis.
ShapeLine rim(double z, double radius, int corners) {
  return circle({0, 0, z}, {radius, 0, 0}, {0, radius, 0}, corners);
}

ShapeLine rectangle(glm::dvec3 half, double z) {
  ShapeLine line;
  for (glm::dvec2 corner : kCorners) line.emplace_back(corner * glm::dvec2(half), z);
  return line;
}

// ---- A function a shape. half: half its size.

void drawNothing(Lines&, glm::dvec3, OutlineDetail) {}

void drawBox(Lines& lines, glm::dvec3 half, OutlineDetail) {
  for (double z : {-half.z, half.z}) lines.push_back(rectangle(half, z));
  for (glm::dvec2 corner : kCorners) {
    glm::dvec2 at = corner * glm::dvec2(half);
    lines.push_back({{at, -half.z}, {at, half.z}});
  }
}

void drawSphere(Lines& lines, glm::dvec3 half, OutlineDetail detail) {
  glm::dvec3 x(half.x, 0, 0), y(0, half.x, 0), z(0, 0, half.x);
  lines.push_back(circle({}, x, y, detail.corners));
  lines.push_back(circle({}, x, z, detail.corners));
  lines.push_back(circle({}, y, z, detail.corners));
}

void drawCylinder(Lines& lines, glm::dvec3 half, OutlineDetail detail) {
  for (double z : {-half.z, half.z}) lines.push_back(rim(z, half.x, detail.corners));
  for (int i = 0; i < detail.sides; ++i) {
    glm::dvec2 at = half.x * onCircle(i, detail.sides);
    lines.push_back({{at, -half.z}, {at, half.z}});
  }
}

void drawCone(Lines& lines, glm::dvec3 half, OutlineDetail detail) {
  lines.push_back(rim(2.0 * half.z, half.x, detail.corners));
  for (int i = 0; i < detail.sides; ++i)
    lines.push_back({{0, 0, 0}, {half.x * onCircle(i, detail.sides), 2.0 * half.z}});
}

void drawMembrane(Lines& lines, glm::dvec3 half, OutlineDetail) { lines.push_back(rectangle(half, 0.0)); }

/// In the order of CutShape.
constexpr void (*kDraw[])(Lines&, glm::dvec3, OutlineDetail) = {drawNothing, drawBox,      drawSphere, drawCylinder,
                                                                drawCone,    drawMembrane, drawNothing};
static_assert(std::size(kDraw) == std::size(EnumNames<CutShape>::kNames), "each shape has its outline");

}  // namespace

std::vector<ShapeLine> shapeOutline(const Cut& cut, OutlineDetail detail) {
  Lines lines;
  kDraw[static_cast<int>(cut.shape)](lines, cut.size * 0.5, detail);
  return lines;
}

}  // namespace velum::scene
