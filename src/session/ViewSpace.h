#pragma once
#include <glm/glm.hpp>
#include <optional>

#include "scene/Camera.h"
#include "scene/SectionPlane.h"

namespace velum::session {

/// A circle in a view, pixels.
struct ViewCircle {
  glm::dvec2 middle{0.0};
  double radius = 0.0;
};

/// What the (logical) pixels of a view mean in the world: the pixels of the 3D picture, or those of a section. A value
/// type: a drag keeps the view space with which it began, so that what is dragged does not run away when the view
/// follows.
class ViewSpace {
 public:
  ViewSpace() = default;
  ViewSpace(const scene::Camera& camera, glm::dvec2 size) : mCamera(camera), mSize(size) {}
  explicit ViewSpace(const scene::SectionPlane& section) : mSize(section.size), mSection(section) {}

  /// The plane of the section; null: the view is the 3D picture.
  const scene::SectionPlane* section() const { return mSection ? &*mSection : nullptr; }
  /// The camera of the 3D picture.
  const scene::Camera& camera() const { return mCamera; }
  glm::dvec2 size() const { return mSize; }

  /// The pixel where a place is seen, or, on a section, the pixel of its foot on the plane; nothing for a place behind
  /// the eye.
  std::optional<glm::dvec2> pixelFromWorld(glm::dvec3 world) const;
  /// Length in the world of a pixel at a place.
  double lengthPerPixel(glm::dvec3 world) const;
  /// Length in the world of a pixel at the camera's target.
  double lengthPerPixel() const { return lengthPerPixel(mCamera.target); }
  /// The circle as which a ball is seen; on a section the circle in which the plane cuts the ball. Nothing where the
  /// plane misses the ball, or the ball is behind the eye.
  std::optional<ViewCircle> circleOfBall(glm::dvec3 middle, double radius) const;

 private:
  scene::Camera mCamera;
  glm::dvec2 mSize{1.0};
  std::optional<scene::SectionPlane> mSection;
};

}  // namespace velum::session
