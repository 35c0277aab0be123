// A membrane on a section: the line of its rest plane, the curve of its sheet, and what can be taken hold of there.
#include "session/cut/SectionMembrane.h"

#include <algorithm>
#include <cmath>

#include "membrane/sheet/SheetCurve.h"
#include "membrane/sheet/SheetIndex.h"
#include "session/cut/CutEdit.h"
#include "session/cut/SectionGeometry.h"

namespace velum::session {

namespace {

using scene::SectionPlane;

/// The knobs stand at most this far from the middle of what is seen of the line; ends nearer together have none.
constexpr double kKnobPixels = 110.0, kLeastLinePixels = 60.0;
constexpr double kFrameMargin = 14.0;
/// A sheet so near to a section that runs along it, in pixels, does not cross it.
constexpr double kFlatPixels = 0.2;

glm::dvec3 localOf(const scene::Cut& cut, glm::dvec3 world) {
  return glm::dvec3(glm::inverse(scene::worldFromCut(cut)) * glm::dvec4(world, 1.0));
}

/// The handle of the side of the plane on which an end of its line lies.
SectionHandle endHandle(const SectionPlane& plane, const scene::Cut& cut, glm::dvec2 end, glm::dvec2 middle) {
  glm::dvec3 local = localOf(cut, scene::worldFromSectionPixel(plane, end)), half = cut.size * 0.5;
  int axis = std::abs(std::abs(local.x) - half.x) <= std::abs(std::abs(local.y) - half.y) ? 0 : 1;
  int sign = local[axis] < 0 ? -1 : 1;
  glm::dvec2 out = onScreen(plane, cutFrame(cut)[axis] * double(sign));
  if (glm::length(out) < 1e-9) out = end - middle;
  return {SectionHandleKind::Face, axis, sign, end, middle, glm::normalize(out)};
}

}  // namespace

std::vector<std::vector<glm::dvec2>> sheetCurves(const SectionPlane& plane, const scene::Cut& cut,
                                                 const scene::SheetShape& live) {
  const scene::Membrane& membrane = *cut.membrane;
  auto shape = membrane::fitShape(live.places.empty() ? membrane.shape : live, membrane.cloth.particles, cut.size);
  glm::dmat4 worldFromCut = scene::worldFromCut(cut);
  glm::dvec3 normal = glm::transpose(glm::dmat3(worldFromCut)) * plane.normal;
  double distance = -scene::heightOverSection(plane, cut.centre);
  // A section along the plane would show where a sheet that hangs flat trembles by a rounding error.
  if (glm::length(glm::dvec2(normal)) < 1e-6) distance += kFlatPixels * plane.lengthPerPixel;
  std::vector<std::vector<glm::dvec2>> curves;
  for (const auto& curve : membrane::crossPlane(shape, glm::vec3(normal), float(distance))) {
    auto& points = curves.emplace_back();
    for (glm::vec3 p : curve.places)
      points.push_back(scene::sectionPixelFromWorld(plane, glm::dvec3(worldFromCut * glm::dvec4(p, 1.0))));
    if (curve.isClosed) points.push_back(points.front());
  }
  return curves;
}

std::optional<std::pair<glm::dvec2, glm::dvec2>> frameLine(const SectionPlane& plane, const scene::Cut& cut) {
  auto line = planeLine(plane, cut);
  if (!line) return std::nullopt;
  glm::dvec3 from = localOf(cut, scene::worldFromSectionPixel(plane, line->point));
  glm::dvec3 along = localOf(cut, scene::worldFromSectionPixel(plane, line->point + line->along)) - from;
  glm::dvec2 half = glm::dvec2(cut.size) * 0.5;
  auto ends = clipLine(glm::dvec2(from), glm::dvec2(along), -half, half);
  if (!ends) return std::nullopt;
  auto pixel = [&](glm::dvec2 local) {
    double t = glm::dot(local - glm::dvec2(from), glm::dvec2(along)) / glm::dot(glm::dvec2(along), glm::dvec2(along));
    return line->point + line->along * t;
  };
  return std::pair(pixel(ends->first), pixel(ends->second));
}

std::vector<SectionHandle> membraneHandles(const SectionPlane& plane, const scene::Cut& cut) {
  auto ends = frameLine(plane, cut);
  auto line = planeLine(plane, cut);
  if (!ends || !line) return {};
  std::vector<SectionHandle> handles;
  glm::dvec2 margin = glm::min(glm::dvec2(kFrameMargin), plane.size * 0.25), way = ends->second - ends->first;
  double length = glm::length(way);
  auto seen = clipLine(line->point, line->along, margin, plane.size - margin);
  if (!seen || length < 1.0) return {};
  auto at = [&](glm::dvec2 p) { return glm::dot(p - ends->first, way) / length; };
  double from = std::max(0.0, std::min(at(seen->first), at(seen->second)));
  double to = std::min(length, std::max(at(seen->first), at(seen->second)));
  if (from >= to) return {};
  glm::dvec2 unit = way / length, middle = ends->first + unit * (0.5 * (from + to));
  if (from == 0.0) handles.push_back(endHandle(plane, cut, ends->first, middle));
  if (to == length) handles.push_back(endHandle(plane, cut, ends->second, middle));
  double out = std::min(kKnobPixels, 0.3 * (to - from));
  if (to - from > kLeastLinePixels)
    for (double side : {-1.0, 1.0})
      handles.push_back({SectionHandleKind::Turn, 0, 0, middle + unit * (side * out), middle, line->across});
  handles.push_back({SectionHandleKind::Move, 0, 0, middle, middle, line->across});
  return handles;
}

}  // namespace velum::session
