#include "scene/timeline/Mix.h"

#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

namespace velum::scene::detail {

namespace {

/// Slope at a key between two steps of a cubic that does not swing beyond its keys. @param h, d  length and slope
double slopeBetween(double h0, double d0, double h1, double d1) {
  if (d0 * d1 <= 0.0) return 0.0;
  double w0 = 2.0 * h1 + h0, w1 = h1 + 2.0 * h0;
  return (w0 + w1) / (w0 / d0 + w1 / d1);
}

glm::dvec3 unitOf(glm::dvec3 v, glm::dvec3 other) {
  double size = glm::length(v);
  return size > 0.0 ? v / size : other;
}

/// Some unit vector across another one.
glm::dvec3 across(glm::dvec3 unit) {
  glm::dvec3 least = std::abs(unit.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return glm::normalize(glm::cross(unit, least));
}

glm::dquat turnOf(glm::dvec3 towards, glm::dvec3 up) {
  glm::dvec3 z = unitOf(towards, {0, -1, 0});
  glm::dvec3 x = glm::cross(up, z);
  x = glm::length(x) > 1e-9 * glm::length(up) ? glm::normalize(x) : across(z);
  return glm::quat_cast(glm::dmat3(x, glm::cross(z, x), z));
}

/// A turn between keys; on smooth paths by the four parts of the quaternions, which the shortest ways keep together.
glm::dquat mixTurn(const std::array<const glm::dquat*, 4>& turns, const Moment& moment) {
  glm::dquat from = *turns[1], to = glm::dot(from, *turns[2]) < 0.0 ? -*turns[2] : *turns[2];
  if (!moment.isSmooth) return glm::slerp(from, to, moment.t);
  glm::dquat before(from), after(to);
  if (turns[0]) before = glm::dot(*turns[0], from) < 0.0 ? -*turns[0] : *turns[0];
  if (turns[3]) after = glm::dot(*turns[3], to) < 0.0 ? -*turns[3] : *turns[3];
  if (!turns[0] && !turns[3]) return glm::slerp(from, to, mixNumber(nullptr, 0.0, 1.0, nullptr, moment));
  glm::dquat out;
  for (int i = 0; i < 4; ++i)
    out[i] = mixNumber(turns[0] ? &before[i] : nullptr, from[i], to[i], turns[3] ? &after[i] : nullptr, moment);
  return glm::normalize(out);
}

/// The frame of each key that is there, and the frame between them.
template <class T, class Frame>
glm::dmat3 mixFrames(const Four<T>& four, const Moment& moment, Frame&& frame) {
  std::array<const T*, 4> values{four.before, four.from, four.to, four.after};
  std::array<glm::dquat, 4> turns;
  std::array<const glm::dquat*, 4> pointers{};
  for (std::size_t i = 0; i < 4; ++i)
    if (values[i]) turns[i] = frame(*values[i]), pointers[i] = &turns[i];
  return glm::mat3_cast(mixTurn(pointers, moment));
}

/// A number of each key that is there, between them.
template <class T, class Get>
double mixOf(const Four<T>& four, const Moment& moment, Get&& get) {
  double before = four.before ? get(*four.before) : 0.0, after = four.after ? get(*four.after) : 0.0;
  return mixNumber(four.before ? &before : nullptr, get(*four.from), get(*four.to), four.after ? &after : nullptr,
                   moment);
}

double armOf(const Camera& camera) { return std::max(glm::distance(camera.eye, camera.target), 1e-12); }

}  // namespace

double mixNumber(const double* before, double from, double to, const double* after, const Moment& moment) {
  if (!std::isfinite(from) || !std::isfinite(to)) return from;
  double t = moment.t;
  if (!moment.isSmooth) return from + (to - from) * t;
  double slope = (to - from) / moment.span;
  auto at = [&](const double* other, double h, double d) {
    return other && std::isfinite(*other) && h > 0.0 ? slopeBetween(h, d, moment.span, slope) : 0.0;
  };
  double m0 = at(before, moment.before, before ? (from - *before) / moment.before : 0.0) * moment.span;
  double m1 = at(after, moment.after, after ? (*after - to) / moment.after : 0.0) * moment.span;
  double t2 = t * t, t3 = t2 * t;
  return from + (to - from) * (3.0 * t2 - 2.0 * t3) + m0 * (t3 - 2.0 * t2 + t) + m1 * (t3 - t2);
}

glm::dvec3 mixDirection(const Four<glm::dvec3>& four, const Moment& moment) {
  glm::dvec3 from = *four.from, to = *four.to;
  double length = mixOf(four, moment, [](glm::dvec3 v) { return glm::length(v); });
  glm::dvec3 a = unitOf(from, {}), b = unitOf(to, {});
  if (a == glm::dvec3(0.0) || b == glm::dvec3(0.0)) return from;
  glm::dvec3 direction{0.0};
  if (moment.isSmooth && (four.before || four.after)) {
    for (int i = 0; i < 3; ++i) direction[i] = mixOf(four, moment, [i](glm::dvec3 v) { return unitOf(v, {})[i]; });
  }
  if (glm::length(direction) > 1e-3 && moment.isSmooth && (four.before || four.after))
    return glm::normalize(direction) * length;
  double t = mixNumber(nullptr, 0.0, 1.0, nullptr, moment);
  double angle = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
  glm::dvec3 side = b - a * glm::dot(a, b);
  side = glm::length(side) > 1e-12 ? glm::normalize(side) : across(a);
  return (a * std::cos(angle * t) + side * std::sin(angle * t)) * length;
}

Camera mixCamera(const Four<Camera>& four, const Moment& moment) {
  Camera out = *four.from;
  glm::dmat3 axes =
      mixFrames(four, moment, [](const Camera& camera) { return turnOf(camera.eye - camera.target, camera.up); });
  for (int i = 0; i < 3; ++i) out.target[i] = mixOf(four, moment, [i](const Camera& c) { return c.target[i]; });
  out.eye = out.target + axes[2] * std::exp(mixOf(four, moment, [](const Camera& c) { return std::log(armOf(c)); }));
  out.up = axes[1];
  out.height = std::exp(mixOf(four, moment, [](const Camera& c) { return std::log(c.height); }));
  out.fieldOfViewDeg = mixOf(four, moment, [](const Camera& c) { return c.fieldOfViewDeg; });
  return out;
}

void mixFrame(glm::dvec3& normal, glm::dvec3& up, const Four<Section>& four, const Moment& moment) {
  glm::dmat3 axes = mixFrames(four, moment, [](const Section& section) { return turnOf(section.normal, section.up); });
  normal = axes[2];
  up = axes[1];
}

}  // namespace velum::scene::detail
