#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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

/// True where two pieces of lines meet: their lines' parameters, solved for.
inline bool doMeet(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
  glm::dvec2 u = b - a, v = d - c, w = c - a;
  double det = u.x * v.y - u.y * v.x;
  if (std::abs(det) < 1e-12) return false;
  double s = (w.x * v.y - w.y * v.x) / det, t = (w.x * u.y - w.y * u.x) / det;
  return s > 1e-9 && s < 1 - 1e-9 && t > 1e-9 && t < 1 - 1e-9;
}

inline bool isInRectangle(glm::dvec2 p, const Rectangle& r) {
  return p.x > r.low.x + 1e-6 && p.y > r.low.y + 1e-6 && p.x < r.high.x - 1e-6 && p.y < r.high.y - 1e-6;
}

/// True where a leader is in a rectangle: by many points on it.
inline bool doesEnter(const std::vector<glm::dvec2>& leader, const Rectangle& r) {
  glm::dvec2 low = glm::min(leader.front(), leader.back()), high = glm::max(leader.front(), leader.back());
  if (glm::any(glm::greaterThan(low, r.high)) || glm::any(glm::lessThan(high, r.low))) return false;
  for (int i = 0; i <= 1000; ++i)
    if (isInRectangle(glm::mix(leader.front(), leader.back(), i / 1000.0), r)) return true;
  return false;
}

inline bool doOverlap(const Rectangle& a, const Rectangle& b) {
  return std::min(a.high.x, b.high.x) - std::max(a.low.x, b.low.x) > 1e-6 &&
         std::min(a.high.y, b.high.y) - std::max(a.low.y, b.low.y) > 1e-6;
}

inline const NameToPlace& nameIn(const NamedScene& scene, int key) {
  return *std::find_if(scene.names.begin(), scene.names.end(), [&](const NameToPlace& n) { return n.key == key; });
}

/// All that must hold of places; of what was fixed by hand only what others owe to it.
inline void expectLaws(const NamedScene& scene, const std::vector<NamePlace>& places) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    const NamePlace& a = places[i];
    const NameToPlace& name = nameIn(scene, a.key);
    ASSERT_GE(a.leader.size(), 2u);
    EXPECT_EQ(a.leader.back(), name.anchor);
    EXPECT_NEAR(glm::distance(a.block.high - a.block.low, name.size), 0.0, 1e-9);
    if (name.fixed) {
      EXPECT_EQ(a.block.low, *name.fixed);
    }
    for (std::size_t j = 0; j < i; ++j) {
      const NamePlace& b = places[j];
      if (name.fixed && nameIn(scene, b.key).fixed) continue;
      EXPECT_FALSE(doOverlap(a.block, b.block));
      EXPECT_FALSE(doMeet(a.leader[0], a.leader[1], b.leader[0], b.leader[1])) << a.key << " " << b.key;
      EXPECT_FALSE(doesEnter(a.leader, b.block)) << a.key << " " << b.key;
      EXPECT_FALSE(doesEnter(b.leader, a.block)) << a.key << " " << b.key;
    }
    if (name.fixed) continue;
    EXPECT_FALSE(doesEnter(a.leader, a.block));
    EXPECT_GE(std::min(a.block.low.x, a.block.low.y), 0.0);
    EXPECT_TRUE(glm::all(glm::lessThanEqual(a.block.high, scene.room.size)));
    for (const Rectangle& taken : scene.room.taken) {
      EXPECT_FALSE(doOverlap(a.block, taken));
      EXPECT_FALSE(doesEnter(a.leader, taken));
    }
  }
}

}  // namespace velum::session
