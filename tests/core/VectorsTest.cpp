#include "core/Vectors.h"

#include <gtest/gtest.h>

#include <limits>

namespace velum {
namespace {

const glm::dvec3 kFallback(0, 0, 1);

TEST(UnitOr, KeepsTheDirectionOfAnyLength) {
  for (double scale : {1e-9, 1.0, 1e9}) {
    glm::dvec3 unit = unitOr(glm::dvec3(3, 0, -4) * scale, kFallback);
    EXPECT_NEAR(glm::distance(unit, glm::dvec3(0.6, 0, -0.8)), 0.0, 1e-15);
  }
}

TEST(UnitOr, WhatHasNoDirectionGivesTheFallback) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  for (glm::dvec3 v :
       {glm::dvec3(0.0), glm::dvec3(1e-13), glm::dvec3(kInfinity, 0, 0), glm::dvec3(0, kNaN, 0), glm::dvec3(1e200)})
    EXPECT_EQ(unitOr(v, kFallback), kFallback);
}

TEST(DistanceToSegment, IsThatToTheNearestOfItsPoints) {
  glm::dvec2 a(0, 0), b(10, 0);
  EXPECT_DOUBLE_EQ(distanceToSegment({4, 3}, a, b), 3.0);
  EXPECT_DOUBLE_EQ(distanceToSegment({13, 4}, a, b), 5.0);
  EXPECT_DOUBLE_EQ(distanceToSegment({-3, -4}, a, b), 5.0);
  EXPECT_DOUBLE_EQ(distanceToSegment({3, 4}, a, a), 5.0);
}

}  // namespace
}  // namespace velum
