#include "scene/Project.h"

#include <algorithm>
#include <cmath>

#include "core/Vectors.h"

namespace velum::scene {

double halfPictureHeight(const Camera& camera) {
  bool perspective = camera.projection == Projection::Perspective;
  return perspective ? std::tan(glm::radians(camera.fieldOfViewDeg) * 0.5) : camera.height * 0.5;
}

CameraBasis cameraBasis(const Camera& camera) {
  CameraBasis basis;
  basis.forward = unitOr(camera.target - camera.eye, {0, 1, 0});
  glm::dvec3 helper = std::abs(basis.forward.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, -1, 0);
  glm::dvec3 right = glm::cross(basis.forward, unitOr(camera.up, {0, 0, 1}));
  basis.right = glm::length(right) > 1e-6 ? glm::normalize(right) : glm::normalize(glm::cross(basis.forward, helper));
  basis.up = glm::cross(basis.right, basis.forward);
  return basis;
}

PictureRay rayFromPixel(const Camera& camera, glm::dvec2 size, glm::dvec2 pixel) {
  CameraBasis basis = cameraBasis(camera);
  double tall = halfPictureHeight(camera), wide = tall * size.x / size.y;
  glm::dvec2 ndc = pixel / size * 2.0 - 1.0;
  glm::dvec3 across = basis.right * (ndc.x * wide) - basis.up * (ndc.y * tall);
  if (camera.projection == Projection::Perspective) return {camera.eye, glm::normalize(basis.forward + across)};
  return {camera.eye + across, basis.forward};
}

std::optional<glm::dvec2> pixelFromWorld(const Camera& camera, glm::dvec2 size, glm::dvec3 world) {
  CameraBasis basis = cameraBasis(camera);
  glm::dvec3 arm = world - camera.eye;
  double depth = glm::dot(arm, basis.forward);
  double scale = 1.0;
  if (camera.projection == Projection::Perspective) {
    if (depth <= 1e-9) return std::nullopt;
    scale = 1.0 / depth;
  }
  double tall = halfPictureHeight(camera), wide = tall * size.x / size.y;
  glm::dvec2 ndc(glm::dot(arm, basis.right) * scale / wide, -glm::dot(arm, basis.up) * scale / tall);
  return (ndc + 1.0) * 0.5 * size;
}

double lengthPerPixel(const Camera& camera, glm::dvec2 size, glm::dvec3 world) {
  double height = 2.0 * halfPictureHeight(camera);
  if (camera.projection == Projection::Perspective) {
    double depth = glm::dot(world - camera.eye, cameraBasis(camera).forward);
    height *= std::max(depth, 1e-9);
  }
  return height / size.y;
}

}  // namespace velum::scene
