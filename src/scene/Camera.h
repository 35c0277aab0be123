#pragma once
#include <glm/glm.hpp>

#include "core/Fields.h"

namespace velum::scene {

enum class Projection { Perspective, Orthographic };

/// Where the eye is. World frame (LPS).
struct Camera {
  Projection projection = Projection::Perspective;
  glm::dvec3 eye{0.0, -500.0, 0.0};  ///< the eye; for orthographic pictures only its direction from the target counts
  glm::dvec3 target{0.0};            ///< the point in the middle of the picture, about which the camera turns
  glm::dvec3 up{0.0, 0.0, 1.0};      ///< what is up in the picture, any length
  double fieldOfViewDeg = 30.0;      ///< perspective: height of the picture as an angle, 1..150
  double height = 400.0;             ///< orthographic: height of the picture at the target, > 0
  bool operator==(const Camera&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("projection", o.projection, FieldInfo{"", {}, "Perspective, or orthographic (parallel)."});
    visit("eye", o.eye, FieldInfo{kLength, {}, "Position of the eye."});
    visit("target", o.target, FieldInfo{kLength, {}, "Point in the middle of the picture."});
    visit("up", o.up, directionInfo("Direction that is up in the picture."));
    visit("fieldOfViewDeg", o.fieldOfViewDeg,
          FieldInfo{"deg", {1, 150}, "Perspective: height of the picture as an angle."});
    visit("height", o.height, FieldInfo{kLength, {1e-9, 1e9}, "Orthographic: height of the picture at the target."});
  }
};

/// Views along the patient's axes, named by where the eye is.
enum class StandardView { Anterior, Posterior, Left, Right, Superior, Inferior, Oblique };

}  // namespace velum::scene

template <>
struct velum::EnumNames<velum::scene::Projection> {
  static constexpr std::string_view kNames[] = {"perspective", "orthographic"};
};
template <>
struct velum::EnumNames<velum::scene::StandardView> {
  static constexpr std::string_view kNames[] = {"anterior", "posterior", "left",   "right",
                                                "superior", "inferior",  "oblique"};
};
