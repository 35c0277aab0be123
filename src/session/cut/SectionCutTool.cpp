// Handles of a cut on a section, and what a drag of them makes of it.
#include "session/cut/SectionCutTool.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/Vectors.h"
#include "session/cut/SectionContour.h"
#include "session/cut/SectionGeometry.h"
#include "session/cut/SectionMembrane.h"
#include "session/cut/ShapeTraits.h"

namespace velum::session {

namespace {

/// A turning knob stands this far outside of the outline, or at most this far from the middle of a plane's line.
constexpr double kKnobOutPixels = 26.0, kPlaneKnobPixels = 110.0;
constexpr double kViewMargin = 24.0;
constexpr double kLeastEdgePixels = 4.0;
constexpr int kDiameterSteps = 12;

using scene::CutShape;
using scene::SectionPlane;

std::vector<SectionHandle> planeHandles(const SectionPlane& plane, const scene::Cut& cut) {
  auto line = planeLine(plane, cut);
  if (!line) return {};
  glm::dvec2 margin = glm::min(glm::dvec2(kViewMargin), plane.size * 0.25);
  auto segment = clipLine(line->point, line->along, margin, plane.size - margin);
  if (!segment) return {};
  glm::dvec2 middle = (segment->first + segment->second) * 0.5;
  double out = std::min(kPlaneKnobPixels, 0.35 * glm::length(segment->second - segment->first));
  std::vector<SectionHandle> handles;
  for (double side : {-1.0, 1.0})
    handles.push_back({SectionHandleKind::Turn, 0, 0, middle + line->along * (side * out), middle, line->across});
  handles.push_back({SectionHandleKind::Move, 0, 0, middle, middle, line->across});
  return handles;
}

glm::dvec2 centroid(const std::vector<glm::dvec2>& points) {
  glm::dvec2 sum(0.0), mean(0.0);
  double area = 0.0;
  for (const auto& p : points) mean += p / double(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    glm::dvec2 a = points[i] - mean, b = points[(i + 1) % points.size()] - mean;
    double twice = a.x * b.y - a.y * b.x;
    area += twice;
    sum += (a + b) * twice;
  }
  return std::abs(area) > 1e-9 ? mean + sum / (3.0 * area) : mean;
}

/// The radius of a round shape at a height of its own frame.
double radiusAt(const scene::Cut& cut, double z) {
  double radius = cut.size.x * 0.5;
  return traitsOf(cut.shape).girth == Girth::Taper ? radius * z / std::max(cut.size.z, 1e-12) : radius;
}

/// Which face or side a piece of the outline lies on, by its middle in the cut's frame.
SectionHandle handleOnShape(const scene::Cut& cut, glm::dvec3 q) {
  const ShapeTraits& traits = traitsOf(cut.shape);
  glm::dvec3 half = cut.size * 0.5;
  if (traits.girth == Girth::Ball) return {SectionHandleKind::Side};
  if (traits.girth == Girth::None) {
    SectionHandle best{SectionHandleKind::Face};
    double least = 1e300;
    for (int axis = 0; axis < 3; ++axis)
      if (double off = std::abs(std::abs(q[axis]) - half[axis]); off < least) {
        least = off;
        best.axis = axis;
        best.sign = q[axis] < 0 ? -1 : 1;
      }
    return best;
  }
  double top = traits.high * cut.size.z, bottom = traits.girth == Girth::Taper ? -1e300 : traits.low * cut.size.z;
  double offSide = std::abs(std::hypot(q.x, q.y) - radiusAt(cut, q.z));
  if (std::abs(q.z - top) < offSide) return {SectionHandleKind::Face, 2, 1};
  if (std::abs(q.z - bottom) < offSide) return {SectionHandleKind::Face, 2, -1};
  return {SectionHandleKind::Side};
}

/// The lines of a closed shape, each as a polygon.
std::vector<std::vector<glm::dvec2>> loopsOf(const SectionOutline& outline) {
  auto loops = outline.curves;
  if (outline.points.size() >= 3) loops.push_back(outline.points);
  return loops;
}

glm::dvec2 middleOf(const SectionOutline& outline) {
  if (outline.curves.empty()) return centroid(outline.points);
  glm::dvec2 low(1e300), high(-1e300);
  for (const auto& curve : outline.curves)
    for (glm::dvec2 p : curve) low = glm::min(low, p), high = glm::max(high, p);
  return (low + high) * 0.5;
}

/// One handle a face, in the middle of its longest piece, or, where pieces are those of a curve, on its top; one for
/// the radius, on the right of the screen.
std::vector<SectionHandle> shapeHandles(const SectionPlane& plane, const scene::Cut& cut, const SectionOutline& outline,
                                        glm::dvec2 middle) {
  const ShapeTraits& traits = traitsOf(cut.shape);
  glm::dmat4 cutFromWorld = glm::inverse(scene::worldFromCut(cut));
  glm::dmat3 axes = cutFrame(cut);
  double mid = 0.5 * (traits.low + traits.high) * cut.size.z;
  bool isCurve = !outline.curves.empty();
  struct Found {
    SectionHandle handle;
    double worth;
  };
  std::vector<Found> found;
  auto look = [&](glm::dvec2 a, glm::dvec2 b) {
    double length = glm::length(b - a);
    if (length < 1e-9) return;
    glm::dvec3 world = scene::worldFromSectionPixel(plane, (a + b) * 0.5);
    glm::dvec3 q(cutFromWorld * glm::dvec4(world, 1.0));
    SectionHandle handle = handleOnShape(cut, q);
    bool isAcross = handle.kind == SectionHandleKind::Face && glm::length(onScreen(plane, axes[handle.axis])) < 0.05;
    if (isCurve && isAcross) handle = {SectionHandleKind::Side};
    handle.place = (a + b) * 0.5;
    handle.pivot = middle;
    glm::dvec2 out((b - a).y / length, -(b - a).x / length);
    bool pointsIn = isCurve ? shapeDistance(cut, scene::worldFromSectionPixel(plane, handle.place + out)) < 0
                            : glm::dot(out, handle.place - middle) < 0;
    handle.outwards = pointsIn ? -out : out;
    bool isSide = handle.kind == SectionHandleKind::Side;
    double worth = isCurve ? handle.sign * q[handle.axis] : length;
    if (isSide) worth = handle.outwards.x + (isCurve ? std::hypot(q.x, q.y) / cut.size.x : 0.0);
    if (isSide && traits.girth != Girth::Ball) worth -= 2.0 * std::abs(q.z - mid) / std::max(cut.size.z, 1e-9);
    auto same = std::find_if(found.begin(), found.end(), [&](const Found& f) {
      return f.handle.kind == handle.kind && f.handle.axis == handle.axis && f.handle.sign == handle.sign;
    });
    if (same == found.end())
      found.push_back({handle, worth});
    else if (worth > same->worth)
      *same = {handle, worth};
  };
  for (const auto& loop : loopsOf(outline))
    for (std::size_t i = 0; i + (isCurve ? 1 : 0) < loop.size(); ++i) look(loop[i], loop[(i + 1) % loop.size()]);
  std::vector<SectionHandle> handles;
  for (const auto& f : found) handles.push_back(f.handle);
  return handles;
}

/// The knob that turns a closed shape stands off it along its axis, or along the edge of a box; none where a turn
/// changes nothing.
std::optional<SectionHandle> turnHandle(const SectionPlane& plane, const scene::Cut& cut, const SectionOutline& outline,
                                        glm::dvec2 middle) {
  if (traitsOf(cut.shape).girth == Girth::Ball) return std::nullopt;
  glm::dmat3 axes = cutFrame(cut);
  glm::dvec2 along = onScreen(plane, axes[2]);
  if (glm::length(along) < 0.05 && hasSides(cut.shape)) along = onScreen(plane, axes[1]);
  if (glm::length(along) < 0.05) return std::nullopt;
  along = glm::normalize(along);
  double reach = 0.0;
  for (const auto& loop : loopsOf(outline))
    for (const auto& p : loop) reach = std::max(reach, glm::dot(p - middle, along));
  return SectionHandle{SectionHandleKind::Turn, 0, 0, middle + along * (reach + kKnobOutPixels), middle, along};
}

/// The diameter for which the shape's side passes as far from the pointer as it did when the side was taken.
double draggedDiameter(const scene::Cut& start, glm::dvec3 from, glm::dvec3 to) {
  double diameter = start.size.x;
  Girth girth = traitsOf(start.shape).girth;
  if (girth == Girth::Ball) return diameter + 2.0 * (glm::length(to - start.centre) - glm::length(from - start.centre));
  glm::dmat3 axes = cutFrame(start);
  auto polar = [&](glm::dvec3 p) {
    glm::dvec3 q = glm::transpose(axes) * (p - start.centre);
    return glm::dvec2(std::hypot(q.x, q.y), q.z);
  };
  glm::dvec2 a = polar(from), b = polar(to);
  if (girth == Girth::Barrel) {
    diameter += 2.0 * (b.x - a.x);
    if (traitsOf(start.shape).isWire) return diameter;
    // Of a side that is not straight that is a guess.
    scene::Cut cut = start;
    for (int i = 0; i < kDiameterSteps; ++i) {
      cut.size.x = diameter;
      diameter += 2.0 * (shapeDistance(cut, to) - shapeDistance(start, from));
    }
    return diameter;
  }
  // On a cone the slope follows: radius over height.
  double least = 0.02 * start.size.z;
  double slope = b.x / std::max(b.y, least) - a.x / std::max(a.y, least);
  return diameter + 2.0 * slope * start.size.z;
}

}  // namespace

bool isArrow(const SectionHandle& handle) {
  return handle.kind == SectionHandleKind::Move && handle.outwards != glm::dvec2(0.0);
}

std::vector<SectionHandle> sectionHandles(const SectionPlane& plane, const scene::Cut& cut) {
  if (cut.shape == CutShape::Plane) return planeHandles(plane, cut);
  if (scene::isMembrane(cut)) return membraneHandles(plane, cut);
  SectionOutline outline = sectionOutline(plane, cut);
  if (loopsOf(outline).empty()) return {};
  glm::dvec2 middle = middleOf(outline);
  std::vector<SectionHandle> handles;
  if (auto turn = turnHandle(plane, cut, outline, middle)) handles.push_back(*turn);
  for (const auto& handle : shapeHandles(plane, cut, outline, middle)) handles.push_back(handle);
  handles.push_back({SectionHandleKind::Move, 0, 0, middle, middle, {}});
  return handles;
}

SectionHandle sectionHandleAt(const SectionPlane& plane, const scene::Cut& cut, glm::dvec2 pixel, double reach,
                              const scene::SheetShape& live) {
  SectionHandle found;
  double nearest = reach;
  for (const auto& handle : sectionHandles(plane, cut)) {
    double distance = glm::length(handle.place - pixel);
    if (distance > nearest || (distance == nearest && found.kind != SectionHandleKind::None)) continue;
    nearest = distance;
    found = handle;
  }
  if (found.kind != SectionHandleKind::None) return found;
  for (const auto& handle : sectionHandles(plane, cut))
    if (isArrow(handle) &&
        distanceToSegment(pixel, handle.place, handle.place + handle.outwards * kSectionArrowPixels) <= reach)
      return handle;
  SectionOutline outline = sectionOutline(plane, cut, live);
  std::size_t count = outline.points.size();
  for (std::size_t i = 0; i + (outline.isClosed ? 0 : 1) < count; ++i)
    if (distanceToSegment(pixel, outline.points[i], outline.points[(i + 1) % count]) <= reach * 0.7)
      return {SectionHandleKind::Move, 0, 0, pixel, pixel, outline.removedSide};
  for (const auto& curve : outline.curves)
    for (std::size_t i = 1; i < curve.size(); ++i)
      if (distanceToSegment(pixel, curve[i - 1], curve[i]) <= reach * 0.7)
        return {SectionHandleKind::Move, 0, 0, pixel, pixel, {}};
  return {};
}

scene::Cut dragSectionCut(const scene::Cut& start, const SectionPlane& plane, const SectionHandle& handle,
                          glm::dvec2 from, glm::dvec2 to, const CutSnap& snap) {
  scene::Cut cut = start;
  if (from == to) return cut;
  glm::dvec3 a = scene::worldFromSectionPixel(plane, from), b = scene::worldFromSectionPixel(plane, to);
  double smallest = kLeastEdgePixels * plane.lengthPerPixel;
  switch (handle.kind) {
    case SectionHandleKind::None:
      break;
    case SectionHandleKind::Move:
      if (isArrow(handle)) {
        glm::dvec3 n = cutFrame(cut)[2];
        cut.centre += n * snappedLength(glm::dot(b - a, n), n, snap);
      } else {
        cut.centre += snappedShift(b - a, snap);
      }
      break;
    case SectionHandleKind::Turn: {
      glm::dvec3 pivot = scene::worldFromSectionPixel(plane, handle.pivot), p = a - pivot, q = b - pivot;
      double angle = std::atan2(glm::dot(glm::cross(p, q), plane.normal), glm::dot(p, q));
      return withTurn(cut, pivot, plane.normal, snappedAngle(angle, snap));
    }
    case SectionHandleKind::Face: {
      glm::dvec3 out = cutFrame(cut)[handle.axis] * double(handle.sign);
      return withFaceMoved(cut, handle.axis, handle.sign, snappedLength(glm::dot(b - a, out), out, snap), smallest);
    }
    case SectionHandleKind::Side: {
      double diameter = draggedDiameter(start, a, b);
      if (snap.on) diameter = start.size.x + 2.0 * snappedLength((diameter - start.size.x) * 0.5, plane.right, snap);
      cut.size.x = std::max(diameter, std::min(smallest, start.size.x));
      break;
    }
  }
  return cut;
}

CutHandle likeInPicture(const SectionHandle& handle) {
  switch (handle.kind) {
    case SectionHandleKind::None:
      break;
    case SectionHandleKind::Move:
      return isArrow(handle) ? CutHandle::Arrow : CutHandle::Centre;
    case SectionHandleKind::Turn:
      return CutHandle::KnobRight;
    case SectionHandleKind::Face:
      return CutHandle(static_cast<int>(CutHandle::FaceXMin) + 2 * handle.axis + (handle.sign > 0 ? 1 : 0));
    case SectionHandleKind::Side:
      return CutHandle::Radius;
  }
  return CutHandle::None;
}

}  // namespace velum::session
