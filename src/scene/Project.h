#pragma once
#include <glm/glm.hpp>
#include <optional>

#include "scene/Camera.h"

namespace velum::scene {

/// The camera's frame, orthonormal whatever the scene says. World, unit vectors.
struct CameraBasis {
  glm::dvec3 right, up, forward;
};
CameraBasis cameraBasis(const Camera& camera);

/// Half the picture's height: at distance 1 (perspective), or anywhere (orthographic).
double halfPictureHeight(const Camera& camera);

/// A ray into the picture: origin at the eye (orthographic: in the eye's plane), unit direction. World.
struct PictureRay {
  glm::dvec3 origin, direction;
};

/// The ray through a place in a picture. The same rays that the renderer casts.
/// @param pixel  continuous, from the top left corner of the picture; pixel centres are at halves
/// @param size   of the whole picture, pixels, positive
PictureRay rayFromPixel(const Camera& camera, glm::dvec2 size, glm::dvec2 pixel);

/// Where a point of the world is in the picture; nothing when it lies behind the eye (perspective).
std::optional<glm::dvec2> pixelFromWorld(const Camera& camera, glm::dvec2 size, glm::dvec3 world);

/// Length in the world, across the line of sight, of one pixel at a point.
double lengthPerPixel(const Camera& camera, glm::dvec2 size, glm::dvec3 world);

}  // namespace velum::scene
