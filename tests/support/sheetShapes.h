#pragma once
#include <cmath>
#include <glm/glm.hpp>
#include <random>
#include <string>
#include <vector>

#include "scene/SheetShape.h"

/// Sheets made by a formula, for tests.
namespace velum {

/// A sheet whose particles are at `placeOf(glm::vec2 across)`, across -1..1 over the frame; the rim is the frame's.
template <class PlaceOf>
scene::SheetShape makeSheet(glm::ivec2 particles, glm::dvec3 size, PlaceOf placeOf) {
  scene::SheetShape shape{particles, {}};
  glm::vec3 half(size * 0.5);
  for (int y = 0; y < particles.y; ++y)
    for (int x = 0; x < particles.x; ++x) {
      glm::vec2 across(2.0f * float(x) / float(particles.x - 1) - 1.0f,
                       2.0f * float(y) / float(particles.y - 1) - 1.0f);
      bool isRim = x == 0 || y == 0 || x + 1 == particles.x || y + 1 == particles.y;
      shape.places.push_back(isRim ? glm::vec3(across, 0.0f) * half : glm::vec3(placeOf(across)));
    }
  return shape;
}

/// 1 in the middle, 0 at the rim, smoothly.
inline float bell(glm::vec2 across) { return (1 - across.x * across.x) * (1 - across.y * across.y); }

inline scene::SheetShape flatSheet(glm::ivec2 n, glm::dvec3 size) {
  return makeSheet(n, size, [&](glm::vec2 s) { return glm::vec3(s, 0.0f) * glm::vec3(size * 0.5); });
}
/// A dome, up to 0.8 of the reach.
inline scene::SheetShape domeSheet(glm::ivec2 n, glm::dvec3 size) {
  return makeSheet(n, size, [&](glm::vec2 s) { return glm::vec3(s, 0.8f * bell(s)) * glm::vec3(size * 0.5); });
}
inline scene::SheetShape wavySheet(glm::ivec2 n, glm::dvec3 size) {
  return makeSheet(n, size, [&](glm::vec2 s) {
    return glm::vec3(s, 0.9f * bell(s) * std::sin(7.0f * s.x + 1.0f) * std::cos(5.0f * s.y)) * glm::vec3(size * 0.5);
  });
}
/// A mushroom: its stalk is narrower than its hat, so that lines along z meet it three times.
inline scene::SheetShape foldedSheet(glm::ivec2 n, glm::dvec3 size) {
  return makeSheet(n, size, [&](glm::vec2 s) {
    float r = glm::length(s), f = std::max(0.0f, 1.0f - r);
    // Where r falls, the place goes in to 0.2, out to 0.5, and in to the middle, rising meanwhile.
    float out = r < 0.3f ? r / 0.3f * 0.5f : r < 0.6f ? 0.5f - (r - 0.3f) : 0.2f + (r - 0.6f) * 2.0f;
    float z = r < 0.3f ? 0.8f : 0.8f * std::min(1.0f, f / 0.7f);
    out = r < 1.0f ? out : r;
    return glm::vec3(r > 0 ? s / r * out : s, z) * glm::vec3(size * 0.5);
  });
}
/// Particles anywhere in the box, near where they hang: crumpled, crossing itself.
inline scene::SheetShape crumpledSheet(glm::ivec2 n, glm::dvec3 size, unsigned seed, float share = 0.25f) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> off(-share, share);
  return makeSheet(n, size, [&](glm::vec2 s) {
    glm::vec3 p(s.x + off(random), s.y + off(random), 3.0f * off(random));
    return glm::clamp(p, -1.0f, 1.0f) * glm::vec3(size * 0.5);
  });
}

struct NamedSheet {
  std::string name;
  scene::SheetShape shape;
};
inline std::vector<NamedSheet> allSheets(glm::ivec2 n, glm::dvec3 size) {
  return {{"flat", flatSheet(n, size)},
          {"dome", domeSheet(n, size)},
          {"waves", wavySheet(n, size)},
          {"folded", foldedSheet(n, size)},
          {"crumpled", crumpledSheet(n, size, 5)}};
}

}  // namespace velum
