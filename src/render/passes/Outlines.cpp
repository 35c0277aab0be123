#include "render/passes/Outlines.h"

#include <algorithm>
#include <cmath>

#include "gpu/Draw.h"
#include "scene/Scene.h"
#include "scene/ShapeOutline.h"
#include "scene/Shown.h"

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
  if (cut.shape == scene::CutShape::Plane) return addPlane(lines, cut, worldFromTex);
  glm::dmat4 frame = scene::worldFromCut(cut);
  auto worldOf = [&](glm::dvec3 p) { return glm::dvec3(frame * glm::dvec4(p, 1)); };
  for (const auto& line : scene::shapeOutline(cut, {})) {
    std::size_t pieces = line.size() == 2 ? 1 : line.size();
    for (std::size_t i = 0; i < pieces; ++i) addLine(lines, worldOf(line[i]), worldOf(line[(i + 1) % line.size()]));
  }
}

}  // namespace

std::vector<glm::dvec3> outlines(const scene::Scene& scene, const glm::dmat4& worldFromTex) {
  std::vector<glm::dvec3> lines;
  addBox(lines, worldFromTex);
  for (const auto& cut : scene::enabledOf(scene.cuts)) addCut(lines, cut, worldFromTex);
  return lines;
}

}  // namespace velum::render
