#pragma once
#include "scene/Camera.h"

namespace velum::scene {

/// Turns the eye about the target: a drag of the whole picture height is half a turn. Turning about the screen's axes,
/// so there is no pole at which it sticks. @param drag  fraction of the picture's height, x right, y down
Camera orbit(const Camera& camera, glm::dvec2 drag);

/// Moves eye and target so that the target follows the drag.
Camera pan(const Camera& camera, glm::dvec2 drag);

/// Changes the distance (perspective) or the height (orthographic) by a factor; < 1 is nearer.
Camera zoom(const Camera& camera, double factor);

/// Turns the eye about the vertical axis of the world through the target, radians; for turntables.
Camera turntable(const Camera& camera, double angleRad);

/// Turns the picture about the line of sight, radians, clockwise.
Camera roll(const Camera& camera, double angleRad);

/// The same place as it is seen from another side, upright: up is superior; seen along it, anterior.
/// @param toEye  direction from the target to the eye, any length over 0
Camera seenFrom(const Camera& camera, glm::dvec3 toEye);

/// On the way from one camera to another, by which the eye goes round and not through what is looked at.
/// @param t  0: from, 1: to
Camera between(const Camera& from, const Camera& to, double t);

/// Seen the other way; what lies at the target keeps its size in the picture.
Camera withProjection(const Camera& camera, Projection projection);

}  // namespace velum::scene
