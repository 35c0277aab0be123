#pragma once
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <limits>
#include <vector>

#include "vector/TraceSteps.h"

namespace velum::vector {

/// A surface as an orthographic camera sees it, a unit of length a pixel.
struct Seen {
  glm::ivec2 size{0};
  std::vector<int> ids;
  std::vector<float> distances;
  std::vector<glm::vec3> normals;
  SurfaceMap map() const { return {size, ids, distances, normals, {}}; }
  View view() const { return {true, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0.5 * size.y}; }
};

/// @param heightAt  towards the eye, nothing where it is not a number; of which the slopes are the normals
inline Seen look(glm::ivec2 size, const std::function<double(glm::dvec2)>& heightAt) {
  Seen seen{size, {}, {}, {}};
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      glm::dvec2 p(x + 0.5, y + 0.5);
      double height = heightAt(p);
      bool isThere = !std::isnan(height);
      seen.ids.push_back(isThere ? 1 : 0);
      seen.distances.push_back(isThere ? float(1000.0 - height) : std::numeric_limits<float>::infinity());
      double dx = heightAt(p + glm::dvec2(0.01, 0)) - height, dy = heightAt(p + glm::dvec2(0, 0.01)) - height;
      if (std::abs(dx) > 1.0 || std::abs(dy) > 1.0) dx = dy = 0.0;  // a step
      seen.normals.push_back(glm::vec3(glm::normalize(glm::dvec3(-dx / 0.01, dy / 0.01, -1.0))));
    }
  return seen;
}

}  // namespace velum::vector
