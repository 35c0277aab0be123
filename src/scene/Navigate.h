#pragma once
#include "scene/Camera.h"

namespace velum::scene {

/// Turns the eye about the target: a drag of the whole picture height is half a turn. It turns about the screen's axes,
/// so that there is no pole at which the drag gets stuck. @param drag  fraction of the picture's height, x right, y
/// down
Camera orbit(const Camera& camera, glm::dvec2 drag);

/// Moves eye and target so that the target follows the drag.
Camera pan(const Camera& camera, glm::dvec2 drag);

/// Changes the distance (perspective) or the height (orthographic) by a factor; < 1 is nearer.
Camera zoom(const Camera& camera, double factor);

/// Turns the eye about the vertical axis of the world through the target, radians; for turntables.
Camera turntable(const Camera& camera, double angleRad);

/// Turns the picture about the line of sight, radians, clockwise.
Camera roll(const Camera& camera, double angleRad);

/// The same target seen from another side, upright: up is the patient's superior, or anterior where one looks along the
/// superior axis.
/// @param toEye  direction from the target to the eye, any length over 0
Camera seenFrom(const Camera& camera, glm::dvec3 toEye);

/// A camera on the way from one camera to another; the eye goes round the things it looks at and not through them.
/// @param t  0: from, 1: to
Camera between(const Camera& from, const Camera& to, double t);

/// The camera with another projection; things at the target keep their size in the picture.
Camera withProjection(const Camera& camera, Projection projection);

}  // namespace velum::scene
