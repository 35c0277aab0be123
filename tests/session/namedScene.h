#pragma once
#include <algorithm>
#include <random>
#include <vector>

#include "session/lettering/PlaceNames.h"

namespace velum::session {

/// Names, and the room that they have.
struct NamedScene {
  std::vector<NameToPlace> names;
  NameRoom room;
};

/// An ellipse as a subject. @param axes  half of its width and height
inline Silhouette ellipseSilhouette(glm::ivec2 picture, glm::dvec2 middle, glm::dvec2 axes) {
  Silhouette out{4, {}};
  for (int y = 2; y < picture.y; y += 4) {
    double v = (y - middle.y) / axes.y, half = v * v < 1.0 ? axes.x * std::sqrt(1.0 - v * v) : -1.0;
    out.rows.push_back({middle.x - half, middle.x + half});
  }
  return out;
}

/// A subject with names somewhere on it, of lines of letters of `em`.
/// @param share  of the picture's width and height that the subject takes
inline NamedScene namedScene(std::mt19937& random, int count, glm::dvec2 share, scene::NameOrder order,
                             glm::ivec2 picture = {1280, 720}) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  glm::dvec2 middle(glm::dvec2(picture) * 0.5), axes = glm::dvec2(picture) * share * 0.5;
  NamedScene out{{}, {glm::dvec2(picture), ellipseSilhouette(picture, middle, axes), {}, order, 16.0}};
  for (int i = 0; i < count; ++i) {
    double turn = unit(random) * 6.2831853, far = std::sqrt(unit(random)) * 0.97;
    glm::dvec2 anchor = middle + axes * far * glm::dvec2(std::cos(turn), std::sin(turn));
    anchor = glm::clamp(anchor, glm::dvec2(1), glm::dvec2(picture) - 1.0);
    int lines = unit(random) < 0.15 ? 2 : 1;
    out.names.push_back({i, {40.0 + 120.0 * unit(random), lines * 19.0}, anchor, 10.0 + unit(random) * 1000.0, {}});
  }
  return out;
}

}  // namespace velum::session
