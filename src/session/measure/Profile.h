#pragma once
#include <glm/glm.hpp>

namespace velum::session {

/// A value on a line.
struct ProfileSample {
  double distance = 0.0;  ///< from the line's first point, scene units
  glm::dvec3 place{0.0};  ///< world
  double value = 0.0;     ///< in the data's unit; NaN outside the volume
  bool operator==(const ProfileSample&) const = default;
};

}  // namespace velum::session
