// How a cut looks in the 3D view, and what of it lies under the pointer.
#include "session/cut/CutGizmo.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/Vectors.h"
#include "scene/Project.h"
#include "scene/Scene.h"
#include "scene/ShapeOutline.h"
#include "session/cut/CutEdit.h"
#include "session/cut/ShapeTraits.h"

namespace velum::session {

namespace {

// Pixels at which arrow and ring could be held and did not hide the picture, tried at 1100 x 800.
constexpr double kArrowPixels = 96.0, kRingPixels = 64.0;
/// Two handles nearer than this are hard to tell apart.
constexpr double kRoomPixels = 18.0;
/// Steeper than this to the line of sight a handle cannot be dragged along its direction (sine of 14 degrees).
constexpr double kLeastSlant = 0.25;

/// The plane inside the scene's box: where it crosses the twelve edges, in order around the middle.
std::vector<glm::dvec3> planeInBox(const scene::Bounds& bounds, glm::dvec3 point, glm::dvec3 normal, glm::dvec3 u,
                                   glm::dvec3 v) {
  auto corner = [&](int i) {
    return glm::dvec3(i & 1 ? bounds.max.x : bounds.min.x, i & 2 ? bounds.max.y : bounds.min.y,
                      i & 4 ? bounds.max.z : bounds.min.z);
  };
  std::vector<glm::dvec3> points;
  for (int a = 0; a < 8; ++a)
    for (int axis = 1; axis < 8; axis *= 2) {
      if (a & axis) continue;
      glm::dvec3 p = corner(a), q = corner(a | axis);
      double dp = glm::dot(p - point, normal), dq = glm::dot(q - point, normal);
      if ((dp < 0) == (dq < 0)) continue;
      points.push_back(p + (q - p) * (dp / (dp - dq)));
    }
  glm::dvec3 middle(0.0);
  for (const auto& p : points) middle += p / double(points.size());
  std::sort(points.begin(), points.end(), [&](const glm::dvec3& p, const glm::dvec3& q) {
    auto angle = [&](const glm::dvec3& x) { return std::atan2(glm::dot(x - middle, v), glm::dot(x - middle, u)); };
    return angle(p) < angle(q);
  });
  return points;
}

std::vector<std::vector<glm::dvec3>> edgesOf(const scene::Cut& cut) {
  glm::dmat4 worldFromCut = scene::worldFromCut(cut);
  auto edges = scene::shapeOutline(cut, {.corners = 48});
  if (scene::isMembrane(cut)) {
    // How far its sheet may go: a box about the rest plane.
    scene::Cut reach = cut;
    reach.shape = scene::CutShape::Box;
    for (auto& line : scene::shapeOutline(reach, {.corners = 48})) edges.push_back(line);
  }
  for (auto& line : edges)
    for (auto& p : line) p = glm::dvec3(worldFromCut * glm::dvec4(p, 1.0));
  return edges;
}

/// The first of some lengths that lies clear of the shape's own handles; else the first.
double clearOf(std::initializer_list<double> lengths, const std::vector<double>& taken) {
  for (double length : lengths)
    if (std::none_of(taken.begin(), taken.end(), [&](double t) { return std::abs(t - length) < kRoomPixels; }))
      return length;
  return *lengths.begin();
}

/// Half sizes at which faces, ends and sides lie.
std::vector<double> faceReaches(const scene::Cut& cut) {
  const ShapeTraits& traits = traitsOf(cut.shape);
  std::vector<double> reaches;
  for (int axis = 0; axis < 3; ++axis)
    if (traits.faces & (1u << axis)) reaches.push_back(cut.size[axis] * 0.5);
  if (traits.girth != Girth::None) reaches.push_back(cut.size.x * 0.5);
  return reaches;
}

void addFaceGrips(CutGizmo& gizmo, const scene::Cut& cut, glm::dvec3 forward) {
  constexpr CutHandle kFaces[] = {CutHandle::FaceXMin, CutHandle::FaceXMax, CutHandle::FaceYMin,
                                  CutHandle::FaceYMax, CutHandle::FaceZMin, CutHandle::FaceZMax};
  glm::dmat3 frame = cutFrame(cut);
  const ShapeTraits& traits = traitsOf(cut.shape);
  for (int face = 0; face < 6; ++face) {
    if (!(traits.faces & (1u << (face / 2)))) continue;
    double sign = face % 2 ? 1.0 : -1.0;
    glm::dvec3 out = frame[face / 2] * sign;
    if (glm::length(glm::cross(out, forward)) < kLeastSlant) continue;  // seen end on
    double reach = cut.size[face / 2] * 0.5;
    if (face / 2 == 2) reach = cut.size.z * (sign > 0 ? traits.high : -traits.low);
    gizmo.grips.push_back({kFaces[face], cut.centre + out * reach, out});
  }
}

/// Adds no grips where the frame is seen edge on: two corners would lie in one place.
void addCornerGrips(CutGizmo& gizmo, const scene::Cut& cut, glm::dvec3 forward) {
  if (std::abs(glm::dot(forward, gizmo.normal)) < kLeastSlant) return;
  glm::dmat3 frame = cutFrame(cut);
  for (int corner = 0; corner < 4; ++corner) {
    glm::dvec2 sign = cornerSigns(corner);
    glm::dvec3 out = frame[0] * (sign.x * cut.size.x * 0.5) + frame[1] * (sign.y * cut.size.y * 0.5);
    auto handle = static_cast<CutHandle>(static_cast<int>(CutHandle::CornerMinMin) + corner);
    gizmo.grips.push_back({handle, cut.centre + out, glm::normalize(out)});
  }
}

void addRadiusGrip(CutGizmo& gizmo, const scene::Cut& cut, const scene::CameraBasis& basis) {
  const ShapeTraits& traits = traitsOf(cut.shape);
  glm::dvec3 out = traits.girth == Girth::Ball ? -basis.right : -gizmo.right;
  glm::dvec3 middle = cut.centre;
  if (traits.girth == Girth::Taper) middle += cutFrame(cut)[2] * (cut.size.z * traits.high);
  gizmo.grips.push_back({CutHandle::Radius, middle + out * (cut.size.x * 0.5), out});
}

/// Adds all places where handles can be taken; where two are equally near to the pointer the first of them wins.
void addGrips(CutGizmo& gizmo, const scene::Cut& cut, const scene::CameraBasis& basis) {
  const ShapeTraits& traits = traitsOf(cut.shape);
  bool isBall = traits.girth == Girth::Ball;
  auto add = [&](CutHandle handle, glm::dvec3 off) { gizmo.grips.push_back({handle, gizmo.centre + off, {}}); };
  if (!isBall) {
    // Of a ring that is seen edge on, two knobs would lie over the middle.
    auto isAside = [&](glm::dvec3 out) { return glm::length(glm::cross(out, basis.forward)) > kLeastSlant; };
    if (isAside(gizmo.right)) add(CutHandle::KnobRight, gizmo.right * gizmo.radius);
    if (isAside(gizmo.top)) add(CutHandle::KnobTop, gizmo.top * gizmo.radius);
    if (isAside(gizmo.right)) add(CutHandle::KnobLeft, -gizmo.right * gizmo.radius);
    if (isAside(gizmo.top)) add(CutHandle::KnobBottom, -gizmo.top * gizmo.radius);
  }
  gizmo.hasRing = !isBall;
  gizmo.grips.push_back({CutHandle::Arrow, gizmo.arrowTip, gizmo.normal});
  if (cut.shape == scene::CutShape::Plane) return;
  addFaceGrips(gizmo, cut, basis.forward);
  if (scene::isMembrane(cut)) addCornerGrips(gizmo, cut, basis.forward);
  if (traits.girth != Girth::None) addRadiusGrip(gizmo, cut, basis);
  if (std::abs(glm::dot(basis.forward, gizmo.normal)) > kLeastSlant)
    add(CutHandle::Square, (gizmo.right + gizmo.top) * (0.4 * gizmo.radius));
  add(CutHandle::Centre, glm::dvec3(0.0));
}

}  // namespace

glm::dvec2 cornerSigns(int corner) { return {corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0}; }

CutGizmo makeCutGizmo(const scene::Scene& scene, const scene::Cut& cut, glm::dvec2 pictureSize) {
  CutGizmo gizmo;
  if (cut.shape == scene::CutShape::Everywhere) return gizmo;
  bool isPlane = cut.shape == scene::CutShape::Plane;
  gizmo.normal = cutFrame(cut)[2] * (isPlane && cut.invert ? -1.0 : 1.0);
  scene::CameraBasis basis = scene::cameraBasis(scene.camera);
  // The knobs stand to the right and to the top as far as the plane allows.
  glm::dvec3 right = basis.right - gizmo.normal * glm::dot(basis.right, gizmo.normal);
  if (glm::length(right) < 0.2) right = basis.forward - gizmo.normal * glm::dot(basis.forward, gizmo.normal);
  gizmo.right = glm::normalize(right);
  gizmo.top = glm::cross(gizmo.normal, gizmo.right);
  if (glm::dot(gizmo.top, basis.up) < 0) gizmo.top = -gizmo.top;
  if (isPlane)
    gizmo.outline = planeInBox(scene::computeBounds(scene), cut.centre, gizmo.normal, gizmo.right, gizmo.top);
  gizmo.edges = edgesOf(cut);
  gizmo.centre = cut.centre;
  // A cone is held by its middle: its own centre is its apex, which has a handle.
  const ShapeTraits& traits = traitsOf(cut.shape);
  gizmo.centre += gizmo.normal * (cut.size.z * 0.5 * (traits.low + traits.high));
  if (!gizmo.outline.empty()) {
    gizmo.centre = glm::dvec3(0.0);
    for (const auto& p : gizmo.outline) gizmo.centre += p / double(gizmo.outline.size());
  }
  gizmo.pixel = scene::lengthPerPixel(scene.camera, pictureSize, gizmo.centre);
  std::vector<double> taken = faceReaches(cut);
  for (double& reach : taken) reach /= gizmo.pixel;
  gizmo.radius = clearOf({kRingPixels, kRingPixels * 0.7, kRingPixels * 1.3}, taken) * gizmo.pixel;
  double arrow = clearOf({kArrowPixels, kArrowPixels * 1.3, kArrowPixels * 1.6}, taken) * gizmo.pixel;
  gizmo.arrowTip = gizmo.centre + gizmo.normal * arrow;
  addGrips(gizmo, cut, basis);
  return gizmo;
}

glm::dvec3 handlePlace(const CutGizmo& gizmo, CutHandle handle) {
  for (const auto& grip : gizmo.grips)
    if (grip.handle == handle) return grip.place;
  return gizmo.centre;
}

std::vector<glm::dvec3> ringPoints(const CutGizmo& gizmo) {
  constexpr int kCorners = 72;
  std::vector<glm::dvec3> points;
  for (int i = 0; i < kCorners; ++i) {
    double a = 2.0 * std::numbers::pi * i / kCorners;
    points.push_back(gizmo.centre + (gizmo.right * std::cos(a) + gizmo.top * std::sin(a)) * gizmo.radius);
  }
  return points;
}

CutHandle handleAt(const CutGizmo& gizmo, const scene::Camera& camera, glm::dvec2 pictureSize, glm::dvec2 pixel,
                   double reach) {
  if (gizmo.grips.empty()) return CutHandle::None;
  CutHandle found = CutHandle::None;
  double nearest = reach;
  for (const auto& grip : gizmo.grips) {
    auto place = scene::pixelFromWorld(camera, pictureSize, grip.place);
    double distance = place ? glm::length(*place - pixel) : reach + 1.0;
    if (distance > nearest || (distance == nearest && found != CutHandle::None)) continue;
    nearest = distance;
    found = grip.handle;
  }
  if (found != CutHandle::None) return found;
  auto foot = scene::pixelFromWorld(camera, pictureSize, gizmo.centre);
  auto tip = scene::pixelFromWorld(camera, pictureSize, gizmo.arrowTip);
  if (foot && tip && distanceToSegment(pixel, *foot, *tip) <= reach) return CutHandle::Arrow;
  if (!gizmo.hasRing) return CutHandle::None;
  auto ring = ringPoints(gizmo);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    auto a = scene::pixelFromWorld(camera, pictureSize, ring[i]);
    auto b = scene::pixelFromWorld(camera, pictureSize, ring[(i + 1) % ring.size()]);
    // The line of the ring is thinner than its knobs, so that a turn of the view is seldom caught by it.
    if (a && b && distanceToSegment(pixel, *a, *b) <= reach * 0.6) return CutHandle::Ring;
  }
  return CutHandle::None;
}

}  // namespace velum::session
