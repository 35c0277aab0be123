// The lines of cuts on a section.
#include "velum/session/cut/SectionOutline.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "SectionGeometry.h"
#include "SectionMembrane.h"

namespace velum::session {

namespace {

/// Corners of a rim: the line then leaves the true curve by a seventh of a pixel at a radius of 1000.
constexpr int kRimCorners = 180;

using scene::CutShape;
using scene::SectionPlane;

/// A shape as corners and the edges between them, in the cut's own frame.
struct Wire {
  std::vector<glm::dvec3> corners;
  std::vector<std::pair<int, int>> edges;
};

Wire boxWire(glm::dvec3 half) {
  Wire wire;
  for (int i = 0; i < 8; ++i)
    wire.corners.push_back({i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z});
  for (int a = 0; a < 8; ++a)
    for (int axis = 1; axis < 8; axis *= 2)
      if (!(a & axis)) wire.edges.emplace_back(a, a | axis);
  return wire;
}

/// Rims at two heights, or an apex (radius 0) and one rim.
Wire roundWire(double lowZ, double lowRadius, double highZ, double highRadius) {
  Wire wire;
  for (int i = 0; i < kRimCorners; ++i) {
    double a = 2.0 * std::numbers::pi * i / kRimCorners;
    glm::dvec2 out(std::cos(a), std::sin(a));
    wire.corners.emplace_back(out * lowRadius, lowZ);
    wire.corners.emplace_back(out * highRadius, highZ);
    int low = 2 * i, nextLow = 2 * ((i + 1) % kRimCorners);
    wire.edges.emplace_back(low, low + 1);
    wire.edges.emplace_back(low + 1, nextLow + 1);
    if (lowRadius > 0) wire.edges.emplace_back(low, nextLow);
  }
  return wire;
}

/// Where the section's plane crosses the wire, around the middle. Pixels.
std::vector<glm::dvec2> crossWire(const SectionPlane& plane, const scene::Cut& cut, const Wire& wire) {
  glm::dmat4 worldFromCut = scene::worldFromCut(cut);
  std::vector<glm::dvec3> world;
  std::vector<double> heights;
  for (const auto& corner : wire.corners) {
    world.emplace_back(worldFromCut * glm::dvec4(corner, 1.0));
    heights.push_back(scene::heightOverSection(plane, world.back()));
  }
  std::vector<glm::dvec2> points;
  for (auto [a, b] : wire.edges) {
    double p = heights[std::size_t(a)], q = heights[std::size_t(b)];
    if ((p < 0) == (q < 0)) continue;
    const glm::dvec3 &from = world[std::size_t(a)], &to = world[std::size_t(b)];
    points.push_back(scene::sectionPixelFromWorld(plane, from + (to - from) * (p / (p - q))));
  }
  glm::dvec2 middle(0.0);
  for (const auto& p : points) middle += p / double(points.size());
  std::sort(points.begin(), points.end(), [&](glm::dvec2 p, glm::dvec2 q) {
    return std::atan2(p.y - middle.y, p.x - middle.x) < std::atan2(q.y - middle.y, q.x - middle.x);
  });
  return points;
}

std::vector<glm::dvec2> circleOnSection(const SectionPlane& plane, const scene::Cut& cut) {
  double h = scene::heightOverSection(plane, cut.centre), radius = cut.size.x * 0.5;
  if (std::abs(h) >= radius) return {};
  double r = std::sqrt(radius * radius - h * h) / plane.lengthPerPixel;
  glm::dvec2 middle = scene::sectionPixelFromWorld(plane, cut.centre);
  std::vector<glm::dvec2> points;
  for (int i = 0; i < kRimCorners; ++i) {
    double a = 2.0 * std::numbers::pi * i / kRimCorners;
    points.push_back(middle + r * glm::dvec2(std::cos(a), std::sin(a)));
  }
  return points;
}

}  // namespace

SectionOutline sectionOutline(const SectionPlane& plane, const scene::Cut& cut, const scene::SheetShape& live) {
  SectionOutline outline;
  glm::dvec3 half = cut.size * 0.5;
  outline.isClosed = cut.shape != CutShape::Plane;
  switch (cut.shape) {
    case CutShape::Plane:
      if (auto line = planeLine(plane, cut)) {
        outline.removedSide = line->across;
        if (auto ends = clipLine(line->point, line->along, glm::dvec2(0.0), plane.size))
          outline.points = {ends->first, ends->second};
      }
      break;
    case CutShape::Membrane:
      outline.isClosed = false;
      outline.curves = sheetCurves(plane, cut, live);
      outline.band = crossWire(plane, cut, boxWire(half));
      if (auto ends = frameLine(plane, cut)) outline.points = {ends->first, ends->second};
      break;
    case CutShape::Box:
      outline.points = crossWire(plane, cut, boxWire(half));
      break;
    case CutShape::Sphere:
      outline.points = circleOnSection(plane, cut);
      break;
    case CutShape::Cylinder:
      outline.points = crossWire(plane, cut, roundWire(-half.z, half.x, half.z, half.x));
      break;
    case CutShape::Cone:
      outline.points = crossWire(plane, cut, roundWire(0.0, 0.0, cut.size.z, half.x));
      break;
  }
  return outline;
}

}  // namespace velum::session
