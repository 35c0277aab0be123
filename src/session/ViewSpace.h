#pragma once
#include <glm/glm.hpp>
#include <optional>

#include "scene/Camera.h"
#include "scene/SectionPlane.h"

namespace velum::session {

/// A circle of a view, pixels.
struct ViewCircle {
  glm::dvec2 middle{0.0};
  double radius = 0.0;
};

/// What the (logical) pixels of a view mean in the world: those of the 3D picture, or those of a section. A value:
/// a drag keeps that with which it began, so that what is dragged does not run away when the view follows.
class ViewSpace {
 public:
  ViewSpace() = default;
  ViewSpace(const scene::Camera& camera, glm::dvec2 size) : mCamera(camera), mSize(size) {}
  explicit ViewSpace(const scene::SectionPlane& section) : mSize(section.size), mSection(section) {}

  /// The plane that is looked at; null: the view is the 3D picture.
  const scene::SectionPlane* section() const { return mSection ? &*mSection : nullptr; }
  /// Of the picture.
  const scene::Camera& camera() const { return mCamera; }
  glm::dvec2 size() const { return mSize; }

  /// Where a place is seen, or its foot on a section; nothing behind the eye.
  std::optional<glm::dvec2> pixelFromWorld(glm::dvec3 world) const;
  /// Length of a pixel at a place.
  double lengthPerPixel(glm::dvec3 world) const;
  /// The same in the middle of what is looked at.
  double lengthPerPixel() const { return lengthPerPixel(mCamera.target); }
  /// A ball as it is seen; on a section the circle in which it is cut. Nothing beside the section or behind the eye.
  std::optional<ViewCircle> circleOfBall(glm::dvec3 middle, double radius) const;

 private:
  scene::Camera mCamera;
  glm::dvec2 mSize{1.0};
  std::optional<scene::SectionPlane> mSection;
};

}  // namespace velum::session
