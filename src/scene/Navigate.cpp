#include "scene/Navigate.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/Vectors.h"

namespace velum::scene {

namespace {

constexpr double kPi = 3.14159265358979323846;

struct Basis {
  glm::dvec3 right, up, toEye;
};

Basis basisOf(const Camera& camera) {
  glm::dvec3 toEye = camera.eye - camera.target;
  toEye = glm::length(toEye) > 1e-12 ? glm::normalize(toEye) : glm::dvec3(0, -1, 0);
  glm::dvec3 right = glm::cross(camera.up, toEye);
  if (glm::length(right) < 1e-9)
    right = glm::cross(std::abs(toEye.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0), toEye);
  right = glm::normalize(right);
  return {right, glm::cross(toEye, right), toEye};
}

glm::dvec3 turn(glm::dvec3 v, double angle, glm::dvec3 axis) {
  return glm::dvec3(glm::rotate(glm::dmat4(1.0), angle, axis) * glm::dvec4(v, 0.0));
}

}  // namespace

Camera orbit(const Camera& camera, glm::dvec2 drag) {
  Basis basis = basisOf(camera);
  glm::dvec3 arm = camera.eye - camera.target;
  arm = turn(turn(arm, -drag.x * kPi, basis.up), -drag.y * kPi, basis.right);
  Camera out = camera;
  out.eye = camera.target + arm;
  out.up = turn(basis.up, -drag.y * kPi, basis.right);
  return out;
}

Camera pan(const Camera& camera, glm::dvec2 drag) {
  Basis basis = basisOf(camera);
  double height =
      camera.projection == Projection::Orthographic
          ? camera.height
          : 2.0 * glm::length(camera.eye - camera.target) * std::tan(glm::radians(camera.fieldOfViewDeg) * 0.5);
  glm::dvec3 move = (-drag.x * basis.right + drag.y * basis.up) * height;
  Camera out = camera;
  out.eye += move;
  out.target += move;
  return out;
}

Camera zoom(const Camera& camera, double factor) {
  factor = std::clamp(factor, 0.05, 20.0);
  Camera out = camera;
  out.eye = camera.target + (camera.eye - camera.target) * factor;
  out.height = std::clamp(camera.height * factor, 1e-9, 1e9);
  return out;
}

Camera turntable(const Camera& camera, double angleRad) {
  Camera out = camera;
  out.eye = camera.target + turn(camera.eye - camera.target, angleRad, {0, 0, 1});
  out.up = turn(camera.up, angleRad, {0, 0, 1});
  return out;
}

Camera roll(const Camera& camera, double angleRad) {
  Basis basis = basisOf(camera);
  Camera out = camera;
  out.up = turn(basis.up, angleRad, basis.toEye);
  return out;
}

Camera seenFrom(const Camera& camera, glm::dvec3 toEye) {
  Camera out = camera;
  toEye = glm::normalize(toEye);
  out.eye = camera.target + toEye * glm::length(camera.eye - camera.target);
  out.up = std::abs(toEye.z) > 0.999 ? glm::dvec3(0, -1, 0) : glm::dvec3(0, 0, 1);
  return out;
}

Camera between(const Camera& from, const Camera& to, double t) {
  if (t >= 1.0) return to;
  auto turnOf = [](const Camera& camera) {
    Basis basis = basisOf(camera);
    return glm::quat_cast(glm::dmat3(basis.right, basis.up, basis.toEye));
  };
  glm::dmat3 axes = glm::mat3_cast(glm::slerp(turnOf(from), turnOf(to), t));
  auto mixScale = [t](double a, double b) {
    return a > 0 && b > 0 ? std::exp(glm::mix(std::log(a), std::log(b), t)) : b;
  };
  Camera out = to;
  out.target = glm::mix(from.target, to.target, t);
  out.eye = out.target + axes[2] * mixScale(glm::length(from.eye - from.target), glm::length(to.eye - to.target));
  out.up = axes[1];
  out.height = mixScale(from.height, to.height);
  return out;
}

Camera withProjection(const Camera& camera, Projection projection) {
  Camera other = camera;
  if (other.projection == projection) return other;
  other.projection = projection;
  double tangent = std::tan(glm::radians(camera.fieldOfViewDeg) * 0.5);
  glm::dvec3 arm = camera.eye - camera.target;
  if (projection == Projection::Orthographic)
    other.height = 2.0 * glm::length(arm) * tangent;
  else
    other.eye = camera.target + unitOr(arm, {0.0, -1.0, 0.0}) * (camera.height * 0.5 / tangent);
  return other;
}

}  // namespace velum::scene
