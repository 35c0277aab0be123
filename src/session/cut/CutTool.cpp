// What a drag of a handle makes of a cut.
#include "session/cut/CutTool.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "scene/Project.h"
#include "session/cut/DragAlong.h"
#include "session/cut/ShapeTraits.h"

namespace velum::session {

namespace {

/// What resizing leaves, pixels: enough to take hold of again.
constexpr double kSmallestPixels = 4.0;
constexpr double kSnapAngleRad = std::numbers::pi / 12.0;

struct Drag {
  const CutGizmo& gizmo;
  const scene::Camera& camera;
  glm::dvec2 size, from, to;
  scene::PictureRay rayAt(glm::dvec2 pixel) const { return scene::rayFromPixel(camera, size, pixel); }
  double along(glm::dvec3 place, glm::dvec3 direction) const {
    return dragAlong(ViewSpace(camera, size), from, to, place, direction);
  }
};

/// Where a ray meets a plane; nothing when it runs beside it.
std::optional<glm::dvec3> meet(const scene::PictureRay& ray, glm::dvec3 point, glm::dvec3 normal) {
  double slant = glm::dot(ray.direction, normal);
  if (std::abs(slant) < 1e-3) return std::nullopt;
  return ray.origin + ray.direction * (glm::dot(point - ray.origin, normal) / slant);
}

glm::dvec3 dragInPlane(const Drag& drag, glm::dvec3 normal) {
  auto a = meet(drag.rayAt(drag.from), drag.gizmo.centre, normal);
  auto b = meet(drag.rayAt(drag.to), drag.gizmo.centre, normal);
  return a && b ? *b - *a : glm::dvec3(0.0);
}

/// The point of the gizmo's sphere under a pixel, on its near side or on its far side; beside the sphere, the nearest
/// point of it. Unit, from the centre.
glm::dvec3 directionOnSphere(const Drag& drag, glm::dvec2 pixel, bool nearSide) {
  scene::PictureRay ray = drag.rayAt(pixel);
  glm::dvec3 w = ray.origin - drag.gizmo.centre;
  double radius = drag.gizmo.radius;
  double b = glm::dot(w, ray.direction), c = glm::dot(w, w) - radius * radius;
  double discriminant = b * b - c;
  double root = discriminant > 0 ? std::sqrt(discriminant) : 0.0;
  return glm::normalize(w + ray.direction * (nearSide ? -b - root : -b + root));
}

scene::Cut tilt(const scene::Cut& start, const Drag& drag, CutHandle handle, const CutSnap& snap) {
  const CutGizmo& gizmo = drag.gizmo;
  glm::dvec3 knob = (handlePlace(gizmo, handle) - gizmo.centre) / gizmo.radius;
  bool nearSide = glm::dot(knob, scene::cameraBasis(drag.camera).forward) <= 0.05;
  auto angleAt = [&](glm::dvec2 pixel) {
    glm::dvec3 d = directionOnSphere(drag, pixel, nearSide);
    return std::atan2(glm::dot(d, gizmo.normal), glm::dot(d, knob));
  };
  // Turning the knob towards the normal turns the normal away from the knob.
  double angle = snappedAngle(angleAt(drag.to) - angleAt(drag.from), snap);
  return withTurn(start, gizmo.centre, glm::cross(knob, gizmo.normal), angle);
}

/// The ring of a box: a turn about its axis.
scene::Cut spin(const scene::Cut& start, const Drag& drag, const CutSnap& snap) {
  const CutGizmo& gizmo = drag.gizmo;
  auto angleAt = [&](glm::dvec2 pixel) {
    scene::PictureRay ray = drag.rayAt(pixel);
    bool isFlat = std::abs(glm::dot(ray.direction, gizmo.normal)) < 0.2;
    glm::dvec3 arm = isFlat ? directionOnSphere(drag, pixel, true)
                            : meet(ray, gizmo.centre, gizmo.normal).value_or(gizmo.centre) - gizmo.centre;
    return std::atan2(glm::dot(arm, gizmo.top), glm::dot(arm, gizmo.right));
  };
  double angle = angleAt(drag.to) - angleAt(drag.from);
  glm::dvec3 axis = glm::cross(gizmo.right, gizmo.top);
  return withTurn(start, gizmo.centre, axis, snappedAngle(std::remainder(angle, 2.0 * std::numbers::pi), snap));
}

/// The ring of the others: its point under the pointer follows it.
scene::Cut tiltFreely(const scene::Cut& start, const Drag& drag, const CutSnap& snap) {
  glm::dvec3 forward = scene::cameraBasis(drag.camera).forward;
  // Of the near and the far point under the pointer, the one that lies on the ring.
  auto offRing = [&](bool nearSide) {
    return std::abs(glm::dot(directionOnSphere(drag, drag.from, nearSide), drag.gizmo.normal));
  };
  bool nearSide = std::abs(glm::dot(forward, drag.gizmo.normal)) > 0.98 || offRing(true) <= offRing(false);
  glm::dvec3 a = directionOnSphere(drag, drag.from, nearSide), b = directionOnSphere(drag, drag.to, nearSide);
  glm::dvec3 axis = glm::cross(a, b);
  double sine = glm::length(axis);
  if (sine < 1e-12) return start;
  return withTurn(start, drag.gizmo.centre, axis / sine, snappedAngle(std::atan2(sine, glm::dot(a, b)), snap));
}

scene::Cut resize(scene::Cut cut, const Drag& drag, CutHandle handle, const CutSnap& snap) {
  auto grip = std::find_if(drag.gizmo.grips.begin(), drag.gizmo.grips.end(),
                           [&](const CutGrip& g) { return g.handle == handle; });
  if (grip == drag.gizmo.grips.end()) return cut;
  double length = snappedLength(drag.along(grip->place, grip->direction), grip->direction, snap);
  double smallest = kSmallestPixels * drag.gizmo.pixel;
  if (handle == CutHandle::Radius) {
    cut.size.x = std::max(cut.size.x + 2.0 * length, std::min(smallest, cut.size.x));
    return cut;
  }
  int face = static_cast<int>(handle) - static_cast<int>(CutHandle::FaceXMin);
  return withFaceMoved(cut, face / 2, face % 2 ? 1 : -1, length, smallest);
}

bool isCorner(CutHandle handle) { return handle >= CutHandle::CornerMinMin; }

scene::Cut resizeCorner(const scene::Cut& start, const Drag& drag, CutHandle handle, const CutSnap& snap) {
  glm::dvec3 shift = glm::transpose(cutFrame(start)) * dragInPlane(drag, drag.gizmo.normal);
  int corner = static_cast<int>(handle) - static_cast<int>(CutHandle::CornerMinMin);
  return withCornerMoved(start, corner, glm::dvec2(shift), kSmallestPixels * drag.gizmo.pixel, snap.on);
}

bool turns(CutHandle handle) { return handle >= CutHandle::KnobRight && handle <= CutHandle::Ring; }

}  // namespace

CutSnap makeCutSnap(const scene::Scene& scene, bool on) {
  CutSnap snap{on};
  if (scene.volume.data)
    snap.worldFromVoxel = glm::dmat3(scene.volume.data->worldFromVoxel);
  else if (scene.labels.data)
    snap.worldFromVoxel = glm::dmat3(scene.labels.data->worldFromVoxel());
  return snap;
}

double snappedLength(double length, glm::dvec3 direction, const CutSnap& snap) {
  if (!snap.on) return length;
  // The step that crosses one voxel along the voxel axis nearest to the direction.
  glm::dvec3 voxels = glm::abs(glm::inverse(snap.worldFromVoxel) * direction);
  double step = 1.0 / std::max(voxels.x, std::max(voxels.y, voxels.z));
  return std::isfinite(step) ? std::round(length / step) * step : length;
}

glm::dvec3 snappedShift(glm::dvec3 shift, const CutSnap& snap) {
  return snap.on ? snap.worldFromVoxel * glm::round(glm::inverse(snap.worldFromVoxel) * shift) : shift;
}

double snappedAngle(double rad, const CutSnap& snap) {
  return snap.on ? std::round(rad / kSnapAngleRad) * kSnapAngleRad : rad;
}

scene::Cut withFaceMoved(scene::Cut cut, int axis, int sign, double length, double smallest) {
  double before = cut.size[axis];
  // A membrane's reach grows to both sides: its rest plane stays.
  bool isReach = scene::isMembrane(cut) && axis == 2;
  if (isReach) {
    cut.size[axis] = std::max(before + 2.0 * length, std::min(smallest, before));
    return cut;
  }
  cut.size[axis] = std::max(before + length, std::min(smallest, before));
  double moved = cut.size[axis] - before;
  // Where the centre lies between the two; an apex that is the centre takes all of the move, its base none.
  const ShapeTraits& traits = traitsOf(cut.shape);
  double share = axis != 2 ? 0.5 : sign < 0 ? traits.high : -traits.low;
  cut.centre += cutFrame(cut)[axis] * (sign * moved * share);
  return cut;
}

scene::Cut withCornerMoved(scene::Cut cut, int corner, glm::dvec2 length, double smallest, bool keepsRatio) {
  glm::dvec2 sign = cornerSigns(corner), edges(cut.size), wider = sign * length;
  if (keepsRatio && glm::dot(edges, edges) > 0.0) {
    double least = std::min(1.0, smallest / std::max(std::min(edges.x, edges.y), 1e-12)) - 1.0;
    wider = edges * std::max(glm::dot(wider, edges) / glm::dot(edges, edges), least);
  }
  cut = withFaceMoved(cut, 0, sign.x < 0 ? -1 : 1, wider.x, smallest);
  return withFaceMoved(cut, 1, sign.y < 0 ? -1 : 1, wider.y, smallest);
}

scene::Cut withTurn(scene::Cut cut, glm::dvec3 pivot, glm::dvec3 axis, double rad) {
  glm::dmat3 turn(glm::rotate(glm::dmat4(1.0), rad, axis));
  cut.centre = pivot + turn * (cut.centre - pivot);
  if (hasSides(cut.shape))
    setCutFrame(cut, turn * cutFrame(cut));
  else
    cut.axis = glm::normalize(turn * cutFrame(cut)[2]);
  return cut;
}

scene::Cut dragCut(const scene::Cut& start, const CutGizmo& gizmo, CutHandle handle, const scene::Camera& camera,
                   glm::dvec2 pictureSize, glm::dvec2 from, glm::dvec2 to, const CutSnap& snap) {
  scene::Cut cut = start;
  if (handle == CutHandle::None || from == to) return cut;
  Drag drag{gizmo, camera, pictureSize, from, to};
  switch (handle) {
    case CutHandle::None:
      break;
    case CutHandle::Arrow:
      cut.centre += gizmo.normal * snappedLength(drag.along(gizmo.centre, gizmo.normal), gizmo.normal, snap);
      break;
    case CutHandle::Centre:
      cut.centre += snappedShift(dragInPlane(drag, scene::cameraBasis(camera).forward), snap);
      break;
    case CutHandle::Square: {
      glm::dvec3 shift = dragInPlane(drag, gizmo.normal);
      for (glm::dvec3 axis : {gizmo.right, gizmo.top})
        cut.centre += axis * snappedLength(glm::dot(shift, axis), axis, snap);
      break;
    }
    case CutHandle::KnobRight:
    case CutHandle::KnobTop:
    case CutHandle::KnobLeft:
    case CutHandle::KnobBottom:
      // A plane turns about the middle of what is seen of it, and is said to lie there from then on.
      if (cut.shape == scene::CutShape::Plane) cut.centre = gizmo.centre;
      return tilt(cut, drag, handle, snap);
    case CutHandle::Ring:
      if (cut.shape == scene::CutShape::Plane) cut.centre = gizmo.centre;
      return hasSides(cut.shape) ? spin(cut, drag, snap) : tiltFreely(cut, drag, snap);
    default:
      return isCorner(handle) ? resizeCorner(cut, drag, handle, snap) : resize(cut, drag, handle, snap);
  }
  return cut;
}

const char* dragLabel(const scene::Cut& cut, CutHandle handle) {
  if (handle == CutHandle::Ring && hasSides(cut.shape)) return "Turn cut";
  if (turns(handle)) return "Tilt cut";
  return handle >= CutHandle::FaceXMin ? "Resize cut" : "Move cut";
}

std::string dragText(const scene::LengthFormat& lengths, const scene::Cut& start, const scene::Cut& now,
                     CutHandle handle) {
  if (turns(handle)) {
    // The angle of the turn from one frame to the other.
    glm::dmat3 turn = cutFrame(now) * glm::transpose(cutFrame(start));
    if (!hasSides(start.shape))
      return fmt::format(
          "{:.1f}\u00b0",
          glm::degrees(std::acos(std::clamp(glm::dot(cutFrame(start)[2], cutFrame(now)[2]), -1.0, 1.0))));
    double trace = turn[0][0] + turn[1][1] + turn[2][2];
    return fmt::format("{:.1f}\u00b0", glm::degrees(std::acos(std::clamp((trace - 1.0) * 0.5, -1.0, 1.0))));
  }
  if (handle == CutHandle::Radius) return "\u2300 " + lengthText(lengths, now.size.x);
  if (isCorner(handle)) return lengthNumber(lengths, now.size.x) + " \u00d7 " + lengthText(lengths, now.size.y);
  if (handle >= CutHandle::FaceXMin) {
    int axis = (static_cast<int>(handle) - static_cast<int>(CutHandle::FaceXMin)) / 2;
    if (scene::isMembrane(now) && axis == 2) return "\u00b1 " + lengthText(lengths, 0.5 * now.size[axis]);
    return lengthText(lengths, now.size[axis]);
  }
  glm::dvec3 shift = now.centre - start.centre;
  if (handle == CutHandle::Arrow) {
    // Signed as the arrow points, which for an inverted plane is against its axis.
    bool isFlipped = start.shape == scene::CutShape::Plane && start.invert;
    return lengthText(lengths, glm::dot(shift, cutFrame(start)[2]) * (isFlipped ? -1.0 : 1.0), true);
  }
  return lengthText(lengths, glm::length(shift));
}

}  // namespace velum::session
