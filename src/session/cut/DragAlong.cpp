#include "session/cut/DragAlong.h"

#include "scene/Project.h"

namespace velum::session {

namespace {

/// An arrow shorter than this on screen points at the eye.
constexpr double kShortArrowPixels = 24.0, kLongArrowPixels = 96.0;
/// Share of a direction that must lie within a section for a drag there to follow it.
constexpr double kLeastInPlane = 0.25;

/// How far along a line the point nearest to a ray lies.
double alongLine(glm::dvec3 point, glm::dvec3 direction, const scene::PictureRay& ray) {
  double b = glm::dot(direction, ray.direction), denominator = 1.0 - b * b;
  if (denominator < 1e-9) return 0.0;
  glm::dvec3 w = point - ray.origin;
  return (b * glm::dot(ray.direction, w) - glm::dot(direction, w)) / denominator;
}

double dragInPicture(const ViewSpace& space, glm::dvec2 from, glm::dvec2 to, glm::dvec3 place, glm::dvec3 direction) {
  double pixel = space.lengthPerPixel(place);
  auto foot = space.pixelFromWorld(place);
  auto tip = space.pixelFromWorld(place + direction * (kLongArrowPixels * pixel));
  if (foot && tip && glm::length(*tip - *foot) >= kShortArrowPixels) {
    auto ray = [&](glm::dvec2 at) { return scene::rayFromPixel(space.camera(), space.size(), at); };
    return alongLine(place, direction, ray(to)) - alongLine(place, direction, ray(from));
  }
  bool towardsEye = glm::dot(direction, scene::cameraBasis(space.camera()).forward) < 0;
  return (to.y - from.y) * pixel * (towardsEye ? 1.0 : -1.0);
}

}  // namespace

double dragAlong(const ViewSpace& space, glm::dvec2 from, glm::dvec2 to, glm::dvec3 place, glm::dvec3 direction) {
  const scene::SectionPlane* section = space.section();
  if (!section) return dragInPicture(space, from, to, place, direction);
  glm::dvec2 inPlane(glm::dot(direction, section->right), glm::dot(direction, section->up));
  glm::dvec2 move = glm::dvec2(to.x - from.x, from.y - to.y) * section->lengthPerPixel;
  if (glm::length(inPlane) < kLeastInPlane)
    return (to.y - from.y) * section->lengthPerPixel * (glm::dot(direction, section->normal) > 0 ? 1.0 : -1.0);
  return glm::dot(move, inPlane) / glm::dot(inPlane, inPlane);
}

}  // namespace velum::session
