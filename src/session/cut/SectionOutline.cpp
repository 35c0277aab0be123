// The lines of cuts on a section.
#include "session/cut/SectionOutline.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "scene/ShapeOutline.h"
#include "session/cut/SectionContour.h"
#include "session/cut/SectionGeometry.h"
#include "session/cut/SectionMembrane.h"
#include "session/cut/ShapeTraits.h"

namespace velum::session {

namespace {

/// Corners of a rim: the line then leaves the true curve by a seventh of a pixel at a radius of 1000.
constexpr int kRimCorners = 180;
constexpr scene::OutlineDetail kFine{.corners = kRimCorners, .sides = kRimCorners};

using scene::CutShape;
using scene::SectionPlane;

/// Where the section's plane crosses lines of a cut's frame, around the middle. Pixels.
std::vector<glm::dvec2> crossLines(const SectionPlane& plane, const scene::Cut& cut,
                                   const std::vector<scene::ShapeLine>& lines) {
  glm::dmat4 worldFromCut = scene::worldFromCut(cut);
  std::vector<glm::dvec2> points;
  for (const auto& line : lines) {
    std::vector<glm::dvec3> world;
    std::vector<double> heights;
    for (const auto& corner : line) {
      world.emplace_back(worldFromCut * glm::dvec4(corner, 1.0));
      heights.push_back(scene::heightOverSection(plane, world.back()));
    }
    std::size_t pieces = line.size() == 2 ? 1 : line.size();
    for (std::size_t a = 0; a < pieces; ++a) {
      std::size_t b = (a + 1) % line.size();
      double p = heights[a], q = heights[b];
      if ((p < 0) == (q < 0)) continue;
      points.push_back(scene::sectionPixelFromWorld(plane, world[a] + (world[b] - world[a]) * (p / (p - q))));
    }
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
  if (cut.shape == scene::CutShape::Everywhere) return {};
  SectionOutline outline;
  const ShapeTraits& traits = traitsOf(cut.shape);
  outline.isClosed = cut.shape != CutShape::Plane && !scene::isMembrane(cut);
  if (cut.shape == CutShape::Plane) {
    if (auto line = planeLine(plane, cut)) {
      outline.removedSide = line->across;
      if (auto ends = clipLine(line->point, line->along, glm::dvec2(0.0), plane.size))
        outline.points = {ends->first, ends->second};
    }
  } else if (scene::isMembrane(cut)) {
    scene::Cut reach = cut;
    reach.shape = CutShape::Box;
    outline.curves = sheetCurves(plane, cut, live);
    outline.band = crossLines(plane, reach, scene::shapeOutline(reach, kFine));
    if (auto ends = frameLine(plane, cut)) outline.points = {ends->first, ends->second};
  } else if (traits.isWire) {
    outline.points = crossLines(plane, cut, scene::shapeOutline(cut, kFine));
  } else if (traits.girth == Girth::Ball) {
    outline.points = circleOnSection(plane, cut);
  } else {
    outline.curves = shapeContour(plane, cut);
  }
  return outline;
}

}  // namespace velum::session
