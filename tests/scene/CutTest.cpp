#include "shared/cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "scene/Cut.h"

namespace velum {
namespace {

using glm::vec2, glm::vec3;
using shared::kCutBox, shared::kCutCone, shared::kCutCylinder, shared::kCutPlane, shared::kCutSphere;

const vec3 kHalves[] = {{20, 12, 30}, {15, 15, 15}, {30, 8, 5}};
constexpr int kKinds[] = {kCutPlane, kCutBox, kCutSphere, kCutCylinder, kCutCone};
static_assert(std::size(kKinds) + 2 == std::size(EnumNames<scene::CutShape>::kNames),
              "all but the membrane, and what is everywhere, which has no surface");
/// Whose intervals along a ray there are.
const std::vector<int> kConvexKinds = [] {
  std::vector<int> kinds;
  std::copy_if(std::begin(kKinds), std::end(kKinds), std::back_inserter(kinds), shared::cutIsConvex);
  return kinds;
}();

std::string nameOf(int kind) { return std::string(enumName(static_cast<scene::CutShape>(kind))); }

/// Whether a point is in the shape, told from its definition alone. Doubles.
bool isInside(int kind, glm::dvec3 half, glm::dvec3 p) {
  double r = std::hypot(p.x, p.y);
  switch (kind) {
    case kCutPlane:
      return p.z > 0;
    case kCutBox:
      return std::abs(p.x) < half.x && std::abs(p.y) < half.y && std::abs(p.z) < half.z;
    case kCutSphere:
      return glm::length(p) < half.x;
    case kCutCylinder:
      return r < half.x && std::abs(p.z) < half.z;
    default:
      return p.z > 0 && p.z < 2 * half.z && r < half.x * p.z / (2 * half.z);
  }
}

/// Points all over the surface, no further apart than about `gap`.
std::vector<vec3> surfaceOf(int kind, vec3 half, float gap) {
  std::vector<vec3> points;
  auto disc = [&](float radius, float z) {
    for (float r = 0; r <= radius + 0.5f * gap; r += gap) {
      float here = std::min(r, radius);
      int n = std::max(1, int(6.3f * here / gap));
      for (int i = 0; i < n; ++i)
        points.emplace_back(here * std::cos(6.2831853f * i / n), here * std::sin(6.2831853f * i / n), z);
    }
  };
  auto side = [&](float r0, float z0, float r1, float z1) {
    int steps = int(std::hypot(r1 - r0, z1 - z0) / gap) + 1;
    for (int k = 0; k <= steps; ++k) {
      float f = float(k) / float(steps), r = r0 + f * (r1 - r0), z = z0 + f * (z1 - z0);
      int n = std::max(1, int(6.3f * r / gap));
      for (int i = 0; i < n; ++i)
        points.emplace_back(r * std::cos(6.2831853f * i / n), r * std::sin(6.2831853f * i / n), z);
    }
  };
  switch (kind) {
    case kCutPlane:
      for (float x = -60; x <= 60; x += gap)
        for (float y = -60; y <= 60; y += gap) points.emplace_back(x, y, 0.0f);
      break;
    case kCutBox:
      for (int axis = 0; axis < 3; ++axis)
        for (float sign : {-1.0f, 1.0f}) {
          int a = (axis + 1) % 3, b = (axis + 2) % 3;
          int na = int(2 * half[a] / gap) + 1, nb = int(2 * half[b] / gap) + 1;
          for (int i = 0; i <= na; ++i)
            for (int k = 0; k <= nb; ++k) {
              vec3 p;
              p[axis] = sign * half[axis];
              p[a] = half[a] * (2.0f * i / na - 1.0f);
              p[b] = half[b] * (2.0f * k / nb - 1.0f);
              points.push_back(p);
            }
        }
      break;
    case kCutSphere: {
      int rings = int(3.15f * half.x / gap) + 1;
      for (int k = 0; k <= rings; ++k) {
        float latitude = 3.1415927f * k / rings, r = half.x * std::sin(latitude);
        int n = std::max(1, int(6.3f * r / gap));
        for (int i = 0; i < n; ++i)
          points.emplace_back(r * std::cos(6.2831853f * i / n), r * std::sin(6.2831853f * i / n),
                              half.x * std::cos(latitude));
      }
      break;
    }
    case kCutCylinder:
      side(half.x, -half.z, half.x, half.z);
      disc(half.x, -half.z);
      disc(half.x, half.z);
      break;
    default:
      side(0, 0, half.x, 2 * half.z);
      disc(half.x, 2 * half.z);
  }
  return points;
}

vec3 randomPoint(std::mt19937& random, float reach) {
  std::uniform_real_distribution<float> place(-reach, reach);
  return {place(random), place(random), place(random)};
}

TEST(CutShapeDistance, IsTheDistanceToTheSurface) {
  constexpr float kGap = 0.5f;
  std::mt19937 random(11);
  for (int kind : kKinds)
    for (vec3 half : kHalves) {
      std::vector<vec3> surface = surfaceOf(kind, half, kGap);
      for (int i = 0; i < 150; ++i) {
        vec3 p = randomPoint(random, 50.0f);
        float nearest = std::numeric_limits<float>::infinity();
        for (vec3 s : surface) nearest = std::min(nearest, glm::dot(p - s, p - s));
        nearest = std::sqrt(nearest);
        float distance = std::abs(shared::cutShapeDistance(kind, half, p));
        // The sampled surface is never nearer than the true one, and further by half the gap's diagonal at most.
        EXPECT_LE(distance, nearest + 1e-3f) << nameOf(kind) << " at " << p.x << " " << p.y << " " << p.z;
        EXPECT_GE(distance, nearest - 0.75f * kGap) << nameOf(kind) << " at " << p.x << " " << p.y << " " << p.z;
      }
    }
}

TEST(CutShapeDistance, IsNegativeInsideOnly) {
  std::mt19937 random(12);
  for (int kind : kKinds)
    for (vec3 half : kHalves)
      for (int i = 0; i < 3000; ++i) {
        vec3 p = randomPoint(random, 45.0f);
        float distance = shared::cutShapeDistance(kind, half, p);
        if (std::abs(distance) < 1e-4f) continue;  // on the surface, as far as floats tell
        EXPECT_EQ(distance < 0.0f, isInside(kind, half, p))
            << nameOf(kind) << " at " << p.x << " " << p.y << " " << p.z;
      }
}

TEST(CutShapeDistance, NeverChangesFasterThanThePointMoves) {
  std::mt19937 random(13);
  for (int kind : kKinds)
    for (vec3 half : kHalves)
      for (int i = 0; i < 3000; ++i) {
        vec3 p = randomPoint(random, 60.0f), q = p + randomPoint(random, i % 2 ? 0.5f : 20.0f);
        float change = std::abs(shared::cutShapeDistance(kind, half, p) - shared::cutShapeDistance(kind, half, q));
        EXPECT_LE(change, glm::length(p - q) + 5e-5f) << nameOf(kind);  // float rounding at 60 mm
      }
}

TEST(CutShapeDistance, IsFiniteOnAxesCornersAndApex) {
  for (int kind : kKinds)
    for (float x : {0.0f, 20.0f, -20.0f, 1e6f})
      for (float y : {0.0f, 12.0f})
        for (float z : {0.0f, 30.0f, 60.0f, -30.0f, -1e6f})
          EXPECT_TRUE(std::isfinite(shared::cutShapeDistance(kind, kHalves[0], {x, y, z}))) << nameOf(kind);
}

struct Line {
  vec3 origin, direction;
  const char* what;
};

/// Rays from outside and inside: random, along an axis, in a plane of two axes, towards the middle or the apex.
std::vector<Line> linesFor(vec3 half, std::mt19937& random) {
  std::vector<Line> lines;
  for (int i = 0; i < 300; ++i) {
    vec3 o = randomPoint(random, i % 3 ? 80.0f : 15.0f);
    vec3 d = randomPoint(random, 1.0f);
    lines.push_back({o, glm::normalize(i % 2 ? randomPoint(random, 15.0f) - o : d), "random"});
  }
  for (int axis = 0; axis < 3; ++axis)
    for (float sign : {-1.0f, 1.0f})
      for (int i = 0; i < 20; ++i) {
        vec3 o = randomPoint(random, 35.0f), d(0.0f), e(0.0f);
        d[axis] = sign;
        lines.push_back({o, d, "along an axis"});
        e[axis] = sign;
        e[(axis + 1) % 3] = 1.0f;
        lines.push_back({o, glm::normalize(e), "in a plane of two axes"});
        vec3 behind = o;
        behind[axis] = -sign * 70.0f;
        lines.push_back({behind, d, "along an axis from outside"});
      }
  for (int i = 0; i < 20; ++i) {
    vec3 o = randomPoint(random, 60.0f);
    lines.push_back({o, glm::normalize(-o), "through the middle or the apex"});
    // Just within and just without the widest radius.
    float near = half.x * (i % 2 ? 0.999f : 1.001f);
    lines.push_back({{near, -70.0f, 0.3f * half.z}, {0, 1, 0}, "tangent"});
    lines.push_back({{-70.0f, near, 0.3f * half.z}, {1, 0, 0}, "tangent"});
  }
  // Along the cone's slope, inside and outside: the quadratic term vanishes.
  vec3 slope = glm::normalize(vec3(half.x, 0.0f, 2.0f * half.z));
  for (float shift : {-3.0f, -0.5f, 0.5f, 3.0f}) {
    lines.push_back({vec3(shift, 0.2f, 0.0f) - 40.0f * slope, slope, "along the cone's slope"});
    lines.push_back({vec3(shift, 0.2f, 0.0f) + 90.0f * slope, -slope, "along the cone's slope"});
  }
  return lines;
}

TEST(CutShapeInterval, HoldsExactlyWhatLiesInside) {
  constexpr float kSlack = 0.02f;  // mm of boundary in which floats may disagree
  std::mt19937 random(14);
  for (int kind : kConvexKinds)
    for (vec3 half : kHalves) {
      int wrong = 0;
      for (const Line& line : linesFor(half, random)) {
        vec2 inside = shared::cutShapeInterval(kind, half, line.origin, line.direction);
        EXPECT_FALSE(std::isnan(inside.x) || std::isnan(inside.y)) << nameOf(kind) << " " << line.what;
        for (float t = -150.0f; t <= 200.0f && wrong < 4; t += 0.37f) {
          glm::dvec3 p = glm::dvec3(line.origin) + double(t) * glm::dvec3(line.direction);
          if (std::abs(shared::cutShapeDistance(kind, half, vec3(p))) < kSlack) continue;
          bool expected = isInside(kind, half, p), found = t > inside.x && t < inside.y;
          if (expected == found) continue;
          ++wrong;
          ADD_FAILURE() << nameOf(kind) << ", half " << half.x << " " << half.y << " " << half.z << ": a ray "
                        << line.what << " from " << line.origin.x << " " << line.origin.y << " " << line.origin.z
                        << " along " << line.direction.x << " " << line.direction.y << " " << line.direction.z
                        << " at t = " << t << " is " << (expected ? "inside" : "outside") << " but the interval is "
                        << inside.x << " .. " << inside.y;
          break;
        }
      }
    }
}

shared::CutData cutOf(int kind, vec3 half, bool invert, const glm::mat4& localFromScene) {
  shared::CutData cut{};
  cut.localFromScene = localFromScene;
  cut.halfSize = glm::vec4(half, invert ? -1.0f : 1.0f);
  cut.kind = glm::ivec4(kind, 0, 0, 0);
  return cut;
}

TEST(CutDistance, InvertTurnsTheSignAndAMovedCutMovesItsRegion) {
  std::mt19937 random(15);
  glm::mat4 move = glm::mat4(1.0f);
  move[3] = glm::vec4(-10, 20, -30, 1);
  for (int kind : kKinds)
    for (int i = 0; i < 500; ++i) {
      vec3 p = randomPoint(random, 60.0f);
      float plain = shared::cutDistance(cutOf(kind, kHalves[0], false, glm::mat4(1.0f)), p, {});
      EXPECT_EQ(shared::cutDistance(cutOf(kind, kHalves[0], true, glm::mat4(1.0f)), p, {}), -plain);
      EXPECT_NEAR(shared::cutDistance(cutOf(kind, kHalves[0], false, move), p + vec3(10, -20, 30), {}), plain, 2e-5f);
    }
}

TEST(CutInterval, OfAMovedAndInvertedCutStillHoldsTheShape) {
  glm::mat4 move = glm::mat4(1.0f);
  move[3] = glm::vec4(0, 0, -100, 1);
  for (bool invert : {false, true}) {
    vec2 inside = shared::cutInterval(cutOf(kCutSphere, kHalves[1], invert, move), {0, 0, 0}, {0, 0, 1});
    EXPECT_NEAR(inside.x, 85.0f, 1e-3f);
    EXPECT_NEAR(inside.y, 115.0f, 1e-3f);
  }
}

/// Of shapes whose stretches are known; the outside of one is not convex.
TEST(CutWalk, GoesOnAsFarAsTheShapeDoes) {
  constexpr float kFrom = -150.0f, kTo = 200.0f, kSmallest = 1e-5f * (kTo - kFrom);
  constexpr float kSlack = 0.05f;  // what steps near a face may step over is not deeper
  std::mt19937 random(16);
  int most = 0;
  for (int kind : kKinds)
    for (bool invert : {false, true})
      for (vec3 half : kHalves) {
        shared::CutData cut = cutOf(kind, half, invert, glm::mat4(1.0f));
        int wrong = 0;
        for (const Line& line : linesFor(half, random)) {
          auto at = [&](float t) { return shared::cutDistance(cut, line.origin + t * line.direction, {}); };
          int runs = 0;
          float t = kFrom;
          while (t < kTo && wrong < 4 && ++runs < 100) {
            shared::CutRun run = shared::cutWalk(cut, line.origin, line.direction, t, kSmallest, kTo);
            bool removes = run.end > t;
            float next = std::min(removes ? run.end : run.next, kTo);
            ASSERT_GT(next, t);
            for (float s = t + 0.01f; s < next; s += 0.41f) {
              float distance = at(s);
              if (std::abs(distance) < kSlack || (distance < 0.0f) == removes) continue;
              ++wrong;
              ADD_FAILURE() << nameOf(kind) << invert << ", a ray " << line.what << " at t = " << s << ", distance "
                            << distance << ", in a run from " << t << " to " << next;
              break;
            }
            if (next < kTo) {
              // A run that is out of steps ends off the face that it goes along.
              EXPECT_LT(std::abs(at(next)), 2.0f * kSlack) << nameOf(kind) << " " << line.what;
            }
            t = next;
          }
          most = std::max(most, runs);
        }
      }
  EXPECT_LT(most, 12) << "runs that end for want of steps are few";
}

TEST(CutWalk, EndsOnTheFace) {
  std::mt19937 random(17);
  int ends = 0;
  for (int kind : kConvexKinds)
    for (int i = 0; i < 2000; ++i) {
      vec3 o = randomPoint(random, 60.0f), d = glm::normalize(randomPoint(random, 12.0f) - o);
      vec2 inside = shared::cutShapeInterval(kind, kHalves[0], o, d);
      if (!(inside.y - inside.x > 1.0f) || inside.x < 0.0f || inside.x > 100.0f) continue;
      ++ends;
      shared::CutRun run = shared::cutWalk(cutOf(kind, kHalves[0], false, glm::mat4(1.0f)), o, d, 0.0f, 1e-3f, 200.0f);
      EXPECT_NEAR(run.next, inside.x, 2e-3f) << nameOf(kind);
    }
  EXPECT_GT(ends, 3000);
}

}  // namespace
}  // namespace velum
