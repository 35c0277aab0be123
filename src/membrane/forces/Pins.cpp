#include "membrane/forces/Pins.h"

#include <algorithm>
#include <cmath>

#include "scene/Scene.h"
#include "shared/cloth.h"

namespace velum::membrane {

namespace {

/// How steep the sheet falls off around a pin: so many times its height away it is back on the rest plane. Chosen by
/// eye on angiograms: less looks like a tent pole, more lifts what was not meant.
constexpr double kRadiusPerHeight = 2.5;
/// At least this share of the rest plane's mean edge, so that a low pin is no needle either.
constexpr double kLeastRadius = 1.0 / 16.0;
/// Pins nearer together than this share of the radius are one: the last that was set.
constexpr double kSamePlace = 1e-3;

glm::dvec3 localPlace(const scene::Cut& cut, glm::dvec3 world) {
  return glm::dvec3(glm::inverse(scene::worldFromCut(cut)) * glm::dvec4(world, 1.0));
}

bool isSided(const scene::Cut& cut) { return cut.membrane->field.rule == scene::KernelRule::Sided; }

/// Inside of the rest plane's rectangle, at a height that the sheet can have.
std::vector<glm::dvec3> pinsInFrame(const scene::Cut& cut) {
  glm::dvec3 half = cut.size * 0.5;
  std::vector<glm::dvec3> pins;
  for (const auto& pin : cut.membrane->pins) {
    glm::dvec3 p = localPlace(cut, pin.place);
    p.z = std::clamp(p.z, -half.z, half.z);
    if (std::abs(p.x) < half.x && std::abs(p.y) < half.y) pins.push_back(p);
  }
  return pins;
}

/// The mesh of a sheet in rows and columns over a place: its lower left particle.
int cellOver(std::span<const float> numbers, double x) {
  auto above = std::upper_bound(numbers.begin() + 1, numbers.end() - 1, float(x));
  return int(above - numbers.begin()) - 1;
}

/// Solves a x = b for a symmetric positive definite matrix, in place. @param a  [n][n]
void solve(std::vector<double>& a, std::vector<double>& b) {
  std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = k + 1; i < n; ++i) {
      double share = a[i * n + k] / a[k * n + k];
      for (std::size_t j = k; j < n; ++j) a[i * n + j] -= share * a[k * n + j];
      b[i] -= share * b[k];
    }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t j = i + 1; j < n; ++j) b[i] -= a[i * n + j] * b[j];
    b[i] /= a[i * n + i];
  }
}

}  // namespace

std::vector<HeldParticle> heldByPins(const scene::Cut& cut, glm::ivec2 particles, std::span<const glm::vec3> places) {
  std::vector<HeldParticle> held;
  if (!isSided(cut)) {
    for (const auto& pin : cut.membrane->pins) {
      glm::ivec2 at(glm::round(glm::clamp(pin.sheet, 0.0, 1.0) * glm::dvec2(particles - 1)));
      held.push_back({at.y * particles.x + at.x, glm::vec3(localPlace(cut, pin.place))});
    }
    return held;
  }
  std::vector<float> xs, ys;
  for (int x = 0; x < particles.x; ++x) xs.push_back(places[std::size_t(x)].x);
  for (int y = 0; y < particles.y; ++y) ys.push_back(places[std::size_t(y * particles.x)].y);
  for (glm::dvec3 pin : pinsInFrame(cut)) {
    int v = cellOver(ys, pin.y) * particles.x + cellOver(xs, pin.x);
    for (int corner : {v, v + 1, v + particles.x, v + particles.x + 1}) held.push_back({corner, glm::vec3(pin)});
  }
  return held;
}

std::vector<PlacedKernel> liftsByPins(const scene::Cut& cut) {
  if (!isSided(cut)) return {};
  std::vector<glm::dvec3> all = pinsInFrame(cut), pins;
  double highest = 0.0;
  for (const auto& pin : all) highest = std::max(highest, std::abs(pin.z));
  if (highest == 0.0) return {};
  double radius = std::max(kRadiusPerHeight * highest, kLeastRadius * meanEdge(cut.size * 0.5));
  for (const auto& pin : all) {
    auto isHere = [&](glm::dvec3 p) { return glm::length(glm::dvec2(p - pin)) < kSamePlace * radius; };
    std::erase_if(pins, isHere);
    pins.push_back(pin);
  }
  std::vector<double> matrix, heights;
  for (const auto& a : pins) {
    for (const auto& b : pins) matrix.push_back(double(shared::liftAt(float(glm::length(glm::dvec2(a - b)) / radius))));
    heights.push_back(a.z);
  }
  solve(matrix, heights);
  std::vector<PlacedKernel> lifts;
  for (std::size_t i = 0; i < pins.size(); ++i) {
    PlacedKernel lift;
    lift.centre = pins[i];
    lift.halfWidth = radius;
    lift.lift = heights[i];
    lifts.push_back(lift);
  }
  return lifts;
}

}  // namespace velum::membrane
