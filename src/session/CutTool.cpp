#include "velum/session/CutTool.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "velum/scene/Project.h"

namespace velum::session {

namespace {

// Pixels at which arrow and ring could be held and did not hide the picture, tried at 1100 x 800.
constexpr double kArrowPixels = 96.0, kRingPixels = 64.0;
/// An arrow shorter than this on screen points at the eye: then the drag's height moves the plane.
constexpr double kShortArrowPixels = 24.0;

glm::dvec3 unitAxis(const scene::Cut& cut) {
  double length = glm::length(cut.axis);
  return length > 1e-12 ? cut.axis / length : glm::dvec3(0, -1, 0);
}

glm::dvec3 middleOf(const scene::Scene& scene) {
  scene::Bounds bounds = scene::computeBounds(scene);
  return (bounds.min + bounds.max) * 0.5;
}

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

/// Edges of a box, rims and sides of a round shape, as closed lines.
std::vector<std::vector<glm::dvec3>> edgesOf(const scene::Cut& cut) {
  constexpr int kCorners = 48;
  glm::dmat4 worldFromCut = scene::worldFromCut(cut);
  glm::dvec3 half = cut.sizeMm * 0.5;
  std::vector<std::vector<glm::dvec3>> edges;
  auto add = [&](const std::vector<glm::dvec3>& local) {
    auto& line = edges.emplace_back();
    for (const auto& p : local) line.emplace_back(worldFromCut * glm::dvec4(p, 1.0));
  };
  auto circle = [&](int axis, double along, double radius) {
    std::vector<glm::dvec3> points(kCorners);
    for (int i = 0; i < kCorners; ++i) {
      double a = 2.0 * std::numbers::pi * i / kCorners;
      points[std::size_t(i)][axis] = along;
      points[std::size_t(i)][(axis + 1) % 3] = radius * std::cos(a);
      points[std::size_t(i)][(axis + 2) % 3] = radius * std::sin(a);
    }
    return points;
  };
  constexpr glm::dvec2 kSides[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  constexpr glm::dvec2 kBoxSides[] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  switch (cut.shape) {
    case scene::CutShape::Plane:
      break;
    case scene::CutShape::Box:
      for (double z : {-half.z, half.z}) {
        std::vector<glm::dvec3> rim;
        for (glm::dvec2 s : kBoxSides) rim.emplace_back(s * glm::dvec2(half), z);
        add(rim);
      }
      for (glm::dvec2 s : kBoxSides) add({{s * glm::dvec2(half), -half.z}, {s * glm::dvec2(half), half.z}});
      break;
    case scene::CutShape::Sphere:
      for (int axis = 0; axis < 3; ++axis) add(circle(axis, 0, half.x));
      break;
    case scene::CutShape::Cylinder:
      for (double z : {-half.z, half.z}) add(circle(2, z, half.x));
      for (glm::dvec2 s : kSides) add({{s * half.x, -half.z}, {s * half.x, half.z}});
      break;
    case scene::CutShape::Cone:
      add(circle(2, 2.0 * half.z, half.x));
      for (glm::dvec2 s : kSides) add({glm::dvec3(0.0), {s * half.x, 2.0 * half.z}});
      break;
  }
  return edges;
}

double distanceToSegment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
  glm::dvec2 ab = b - a;
  double length2 = glm::dot(ab, ab);
  double t = length2 > 0 ? std::clamp(glm::dot(p - a, ab) / length2, 0.0, 1.0) : 0.0;
  return glm::length(p - a - ab * t);
}

/// How far along a line the point nearest to a ray lies, mm.
double alongLine(glm::dvec3 point, glm::dvec3 direction, const scene::PictureRay& ray) {
  double b = glm::dot(direction, ray.direction), denominator = 1.0 - b * b;
  if (denominator < 1e-9) return 0.0;
  glm::dvec3 w = point - ray.originMm;
  return (b * glm::dot(ray.direction, w) - glm::dot(direction, w)) / denominator;
}

/// The point of a sphere under a ray, on its near side or on its far side; beside the sphere, the nearest point of it.
glm::dvec3 directionOnSphere(glm::dvec3 centre, double radius, const scene::PictureRay& ray, bool nearSide) {
  glm::dvec3 w = ray.originMm - centre;
  double b = glm::dot(w, ray.direction), c = glm::dot(w, w) - radius * radius;
  double discriminant = b * b - c;
  double root = discriminant > 0 ? std::sqrt(discriminant) : 0.0;
  return glm::normalize(w + ray.direction * (nearSide ? -b - root : -b + root));
}

double moveAlongNormal(const CutGizmo& gizmo, const scene::Camera& camera, glm::dvec2 size, glm::dvec2 from,
                       glm::dvec2 to) {
  auto foot = scene::pixelFromWorld(camera, size, gizmo.centreMm);
  auto tip = scene::pixelFromWorld(camera, size, gizmo.arrowTipMm);
  if (foot && tip && glm::length(*tip - *foot) >= kShortArrowPixels)
    return alongLine(gizmo.centreMm, gizmo.normal, scene::rayFromPixel(camera, size, to)) -
           alongLine(gizmo.centreMm, gizmo.normal, scene::rayFromPixel(camera, size, from));
  // Seen end on: pulling down pulls the plane towards the eye.
  bool towardsEye = glm::dot(gizmo.normal, scene::cameraBasis(camera).forward) < 0;
  return (to.y - from.y) * scene::mmPerPixel(camera, size, gizmo.centreMm) * (towardsEye ? 1.0 : -1.0);
}

double tiltAngle(const CutGizmo& gizmo, glm::dvec3 knob, const scene::Camera& camera, glm::dvec2 size, glm::dvec2 from,
                 glm::dvec2 to) {
  bool nearSide = glm::dot(knob, scene::cameraBasis(camera).forward) <= 0.05;
  auto angleAt = [&](glm::dvec2 pixel) {
    glm::dvec3 d =
        directionOnSphere(gizmo.centreMm, gizmo.radiusMm, scene::rayFromPixel(camera, size, pixel), nearSide);
    return std::atan2(glm::dot(d, gizmo.normal), glm::dot(d, knob));
  };
  return angleAt(to) - angleAt(from);
}

}  // namespace

CutGizmo makeCutGizmo(const scene::Scene& scene, const scene::Cut& cut, glm::dvec2 pictureSize) {
  CutGizmo gizmo;
  bool isPlane = cut.shape == scene::CutShape::Plane;
  gizmo.normal = unitAxis(cut) * (isPlane && cut.invert ? -1.0 : 1.0);
  scene::CameraBasis basis = scene::cameraBasis(scene.camera);
  // The knobs stand to the right and to the top as far as the plane allows.
  glm::dvec3 right = basis.right - gizmo.normal * glm::dot(basis.right, gizmo.normal);
  if (glm::length(right) < 0.2) right = basis.forward - gizmo.normal * glm::dot(basis.forward, gizmo.normal);
  gizmo.right = glm::normalize(right);
  gizmo.top = glm::cross(gizmo.normal, gizmo.right);
  if (glm::dot(gizmo.top, basis.up) < 0) gizmo.top = -gizmo.top;
  if (isPlane)
    gizmo.outlineMm = planeInBox(scene::computeBounds(scene), cut.centreMm, gizmo.normal, gizmo.right, gizmo.top);
  gizmo.edgesMm = edgesOf(cut);
  gizmo.centreMm = cut.centreMm;
  if (!gizmo.outlineMm.empty()) {
    gizmo.centreMm = glm::dvec3(0.0);
    for (const auto& p : gizmo.outlineMm) gizmo.centreMm += p / double(gizmo.outlineMm.size());
  }
  double pixelMm = scene::mmPerPixel(scene.camera, pictureSize, gizmo.centreMm);
  gizmo.radiusMm = kRingPixels * pixelMm;
  gizmo.arrowTipMm = gizmo.centreMm + gizmo.normal * (kArrowPixels * pixelMm);
  return gizmo;
}

glm::dvec3 handlePlaceMm(const CutGizmo& gizmo, CutHandle handle) {
  switch (handle) {
    case CutHandle::Arrow:
      return gizmo.arrowTipMm;
    case CutHandle::KnobRight:
      return gizmo.centreMm + gizmo.right * gizmo.radiusMm;
    case CutHandle::KnobTop:
      return gizmo.centreMm + gizmo.top * gizmo.radiusMm;
    case CutHandle::KnobLeft:
      return gizmo.centreMm - gizmo.right * gizmo.radiusMm;
    case CutHandle::KnobBottom:
      return gizmo.centreMm - gizmo.top * gizmo.radiusMm;
    case CutHandle::None:
      break;
  }
  return gizmo.centreMm;
}

CutHandle handleAt(const CutGizmo& gizmo, const scene::Camera& camera, glm::dvec2 pictureSize, glm::dvec2 pixel,
                   double reach) {
  auto foot = scene::pixelFromWorld(camera, pictureSize, gizmo.centreMm);
  auto tip = scene::pixelFromWorld(camera, pictureSize, gizmo.arrowTipMm);
  for (auto handle : {CutHandle::KnobRight, CutHandle::KnobTop, CutHandle::KnobLeft, CutHandle::KnobBottom}) {
    auto place = scene::pixelFromWorld(camera, pictureSize, handlePlaceMm(gizmo, handle));
    if (place && glm::length(*place - pixel) <= reach) return handle;
  }
  if (foot && tip && distanceToSegment(pixel, *foot, *tip) <= reach) return CutHandle::Arrow;
  return CutHandle::None;
}

scene::Cut dragCut(const scene::Cut& start, const CutGizmo& gizmo, CutHandle handle, const scene::Camera& camera,
                   glm::dvec2 pictureSize, glm::dvec2 from, glm::dvec2 to) {
  scene::Cut cut = start;
  if (handle == CutHandle::None || from == to) return cut;
  if (handle == CutHandle::Arrow) {
    cut.centreMm += gizmo.normal * moveAlongNormal(gizmo, camera, pictureSize, from, to);
    return cut;
  }
  glm::dvec3 knob = (handlePlaceMm(gizmo, handle) - gizmo.centreMm) / gizmo.radiusMm;
  double angle = tiltAngle(gizmo, knob, camera, pictureSize, from, to);
  // Turning the knob towards the normal turns the normal away from the knob.
  glm::dmat3 turn(glm::rotate(glm::dmat4(1.0), angle, glm::cross(knob, gizmo.normal)));
  cut.axis = glm::normalize(turn * unitAxis(start));
  cut.centreMm = gizmo.centreMm;
  return cut;
}

scene::Cut cutFacingCamera(const scene::Scene& scene) {
  scene::Cut cut;
  cut.centreMm = middleOf(scene);
  cut.axis = -scene::cameraBasis(scene.camera).forward;
  // A view along an axis gives a cut along it, without the noise of the sines.
  for (int i = 0; i < 3; ++i)
    if (std::abs(cut.axis[i]) < 1e-9) cut.axis[i] = 0.0;
  return cut;
}

CutPosition cutPosition(const scene::Scene& scene, const scene::Cut& cut) {
  scene::Bounds bounds = scene::computeBounds(scene);
  glm::dvec3 axis = unitAxis(cut);
  return {glm::dot(cut.centreMm - (bounds.min + bounds.max) * 0.5, axis),
          glm::dot((bounds.max - bounds.min) * 0.5, glm::abs(axis))};
}

scene::Cut withOffset(const scene::Scene& scene, scene::Cut cut, double offsetMm) {
  cut.centreMm += unitAxis(cut) * (offsetMm - cutPosition(scene, cut).offsetMm);
  return cut;
}

}  // namespace velum::session
