#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "core/Color.h"

namespace velum {

/// Eyes that see as most do, or lack the cones for long, middle or short waves.
enum class Eyes { Full, NoLong, NoMiddle, NoShort };
constexpr Eyes kAllEyes[] = {Eyes::Full, Eyes::NoLong, Eyes::NoMiddle, Eyes::NoShort};

/// The colour as such eyes see it, by the matrices for complete lack of [MOF09], on linear colours.
/// @return linear, 0..1
inline glm::dvec3 linearAsSeen(glm::vec3 srgb, Eyes eyes) {
  glm::dvec3 c;
  for (int i = 0; i < 3; ++i) c[i] = linearFromSrgb(double(srgb[i]));
  auto rows = [&](glm::dvec3 r, glm::dvec3 g, glm::dvec3 b) {
    return glm::clamp(glm::dvec3(glm::dot(r, c), glm::dot(g, c), glm::dot(b, c)), 0.0, 1.0);
  };
  switch (eyes) {
    case Eyes::NoLong:
      return rows({0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998});
    case Eyes::NoMiddle:
      return rows({0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881});
    case Eyes::NoShort:
      return rows({1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900});
    default:
      return c;
  }
}

/// Lightness, and how far to red and to yellow, in Oklab, by the matrices of [OKLAB].
inline glm::dvec3 oklabOf(glm::vec3 srgb, Eyes eyes = Eyes::Full) {
  glm::dvec3 c = linearAsSeen(srgb, eyes);
  double l = std::cbrt(0.4122214708 * c.x + 0.5363325363 * c.y + 0.0514459929 * c.z);
  double m = std::cbrt(0.2119034982 * c.x + 0.6806995451 * c.y + 0.1073969566 * c.z);
  double s = std::cbrt(0.0883024619 * c.x + 0.2817188376 * c.y + 0.6299787005 * c.z);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

/// How far two colours are apart in Oklab for the eyes that tell them apart least; about 0.02 is just seen.
inline double leastApart(glm::vec3 a, glm::vec3 b) {
  double least = 1e9;
  for (Eyes eyes : kAllEyes) least = std::min(least, glm::length(oklabOf(a, eyes) - oklabOf(b, eyes)));
  return least;
}

}  // namespace velum
