#pragma once
#include <glm/glm.hpp>

#include "scene/Camera.h"
#include "scene/Sections.h"

/// The leaves of Mix.h: numbers, directions and frames between keys.
namespace velum::scene::detail {

/// Where between two keys: `t` is eased already. Smooth paths look at the keys on both sides, too.
struct Moment {
  double t = 0.0;                                ///< 0: at the key before, 1: at the key after; below 1
  bool isSmooth = false;                         ///< cubic through the keys on both sides, where there are such
  double before = 0.0, span = 1.0, after = 0.0;  ///< seconds between these keys; before, after: 0 where there is none
};

/// The values of the four keys about a moment; `before` and `after` are null where there are none.
template <class T>
struct Four {
  const T *before = nullptr, *from = nullptr, *to = nullptr, *after = nullptr;
};

/// A number between keys: linear; smooth: a cubic whose slopes at the keys are the weighted harmonic means of those on
/// both sides (Fritsch and Butland 1984), 0 at the first and the last key and where the numbers turn back, so that it
/// never leaves the interval of its two keys. Endless numbers hold. @param before, after  nullptr: no key there
double mixNumber(const double* before, double from, double to, const double* after, const Moment& moment);
template <class T>
double mixNumber(const Four<T>& four, const Moment& moment) {
  double before = four.before ? double(*four.before) : 0.0, after = four.after ? double(*four.after) : 0.0;
  return mixNumber(four.before ? &before : nullptr, double(*four.from), double(*four.to), four.after ? &after : nullptr,
                   moment);
}

/// A direction between keys: it turns on the shortest way; its length goes along.
glm::dvec3 mixDirection(const Four<glm::dvec3>& four, const Moment& moment);
/// A camera between keys: turned by quaternions on the shortest way about its target, with the distance and height
/// mixed by their logarithms.
Camera mixCamera(const Four<Camera>& four, const Moment& moment);
/// The frame of a section between keys, turned by quaternions on the shortest way.
void mixFrame(glm::dvec3& normal, glm::dvec3& up, const Four<Section>& four, const Moment& moment);

}  // namespace velum::scene::detail
