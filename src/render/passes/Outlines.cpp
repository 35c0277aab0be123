#include "Outlines.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "velum/gpu/Draw.h"

namespace velum::render {

namespace {

void addLine(std::vector<glm::dvec3>& lines, glm::dvec3 a, glm::dvec3 b) {
  lines.push_back(a);
  lines.push_back(b);
}

void addBox(std::vector<glm::dvec3>& lines, const glm::dmat4& worldFromUnit) {
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 4; ++side) {
      glm::dvec3 a(0.0);
      a[(axis + 1) % 3] = side & 1;
      a[(axis + 2) % 3] = side >> 1;
      glm::dvec3 b = a;
      b[axis] = 1.0;
      addLine(lines, glm::dvec3(worldFromUnit * glm::dvec4(a, 1)), glm::dvec3(worldFromUnit * glm::dvec4(b, 1)));
    }
}

void addCircle(std::vector<glm::dvec3>& lines, const glm::dmat4& frame, glm::dvec3 centre, glm::dvec3 x, glm::dvec3 y) {
  constexpr int kSides = 64;
  auto at = [&](int i) {
    double angle = 2.0 * 3.14159265358979 * i / kSides;
    return glm::dvec3(frame * glm::dvec4(centre + std::cos(angle) * x + std::sin(angle) * y, 1.0));
  };
  for (int i = 0; i < kSides; ++i) addLine(lines, at(i), at(i + 1));
}

/// The polygon in which a plane meets the data's box, as its edges.
void addPlane(std::vector<glm::dvec3>& lines, const scene::Cut& cut, const glm::dmat4& worldFromTex) {
  std::vector<glm::dvec3> edges;
  addBox(edges, worldFromTex);
  glm::dmat4 frame = scene::worldFromCut(cut);
  glm::dvec3 normal(frame[2]), x(frame[0]), y(frame[1]);
  std::vector<glm::dvec3> corners;
  for (std::size_t i = 0; i < edges.size(); i += 2) {
    double a = glm::dot(edges[i] - cut.centre, normal), b = glm::dot(edges[i + 1] - cut.centre, normal);
    if ((a < 0) != (b < 0)) corners.push_back(glm::mix(edges[i], edges[i + 1], a / (a - b)));
  }
  if (corners.size() < 3) return;
  glm::dvec3 middle(0.0);
  for (auto& c : corners) middle += c / double(corners.size());
  auto angle = [&](glm::dvec3 c) { return std::atan2(glm::dot(c - middle, y), glm::dot(c - middle, x)); };
  std::sort(corners.begin(), corners.end(), [&](auto a, auto b) { return angle(a) < angle(b); });
  for (std::size_t i = 0; i < corners.size(); ++i) addLine(lines, corners[i], corners[(i + 1) % corners.size()]);
}

void addCut(std::vector<glm::dvec3>& lines, const scene::Cut& cut, const glm::dmat4& worldFromTex) {
  glm::dmat4 frame = scene::worldFromCut(cut);
  glm::dvec3 half = cut.size * 0.5;
  glm::dvec3 x(half.x, 0, 0), y(0, half.x, 0), z(0, 0, half.z);
  switch (cut.shape) {
    case scene::CutShape::Plane:
      addPlane(lines, cut, worldFromTex);
      break;
    case scene::CutShape::Membrane: {
      glm::dvec3 across(0, half.y, 0), corners[] = {-x - across, x - across, x + across, across - x};
      for (int i = 0; i < 4; ++i)
        addLine(lines, glm::dvec3(frame * glm::dvec4(corners[i], 1)),
                glm::dvec3(frame * glm::dvec4(corners[(i + 1) % 4], 1)));
      break;
    }
    case scene::CutShape::Box: {
      glm::dmat4 unit(1.0);
      for (int i = 0; i < 3; ++i) unit[i][i] = cut.size[i], unit[3][i] = -half[i];
      addBox(lines, frame * unit);
      break;
    }
    case scene::CutShape::Sphere:
      addCircle(lines, frame, {}, x, y);
      addCircle(lines, frame, {}, x, {0, 0, half.x});
      addCircle(lines, frame, {}, y, {0, 0, half.x});
      break;
    case scene::CutShape::Cylinder:
    case scene::CutShape::Cone: {
      bool cone = cut.shape == scene::CutShape::Cone;
      glm::dvec3 top = cone ? 2.0 * z : z, bottom = cone ? glm::dvec3(0.0) : -z;
      addCircle(lines, frame, top, x, y);
      if (!cone) addCircle(lines, frame, bottom, x, y);
      for (auto side : {x, -x, y, -y})
        addLine(lines, glm::dvec3(frame * glm::dvec4(top + side, 1)),
                glm::dvec3(frame * glm::dvec4(cone ? bottom : bottom + side, 1)));
      break;
    }
  }
}

}  // namespace

std::vector<glm::dvec3> outlines(const scene::Scene& scene, const glm::dmat4& worldFromTex) {
  std::vector<glm::dvec3> lines;
  addBox(lines, worldFromTex);
  for (const auto& cut : scene.cuts)
    if (cut.enabled) addCut(lines, cut, worldFromTex);
  return lines;
}

}  // namespace velum::render
