#include "vector/Drawing.h"

#include <gtest/gtest.h>

#include <cmath>

namespace velum::vector {
namespace {

glm::dvec2 at(glm::dvec2 from, const Curve& curve, double t) {
  double s = 1.0 - t;
  return s * s * s * from + 3.0 * s * s * t * curve.control1 + 3.0 * s * t * t * curve.control2 + t * t * t * curve.end;
}

TEST(Drawing, ACircleIsRoundAndClosed) {
  Outline outline = circle({10, 20}, 7.0);
  ASSERT_TRUE(outline.isClosed);
  glm::dvec2 from = outline.start;
  for (const Curve& curve : outline.curves) {
    for (double t = 0.0; t <= 1.0; t += 0.05)
      EXPECT_NEAR(glm::distance(at(from, curve, t), glm::dvec2(10, 20)), 7.0, 7.0 * 3e-4);
    from = curve.end;
  }
  EXPECT_NEAR(glm::distance(from, outline.start), 0.0, 1e-12);
}

TEST(Drawing, LinesThroughPointsAreStraightAndEndAtThem) {
  Outline outline = outlineThrough({{0, 0}, {3, 1}, {3, 9}}, true);
  ASSERT_EQ(outline.curves.size(), 3u);
  EXPECT_TRUE(isStraight(outline.start, outline.curves[0]));
  EXPECT_EQ(outline.curves[1].end, glm::dvec2(3, 9));
  EXPECT_EQ(outline.curves[2].end, outline.start);
  EXPECT_FALSE(isStraight({0, 0}, {{1, 1}, {2, 0}, {3, 0}}));
  EXPECT_FALSE(isStraight({0, 0}, {{-1, 0}, {2, 0}, {3, 0}}));
}

TEST(Drawing, ARectanglesCornersAreRoundAndItsEndsMeet) {
  for (double radius : {0.0, 2.0}) {
    Outline outline = rectangle({1, 2}, {11, 8}, radius);
    glm::dvec2 from = outline.start;
    for (const Curve& curve : outline.curves) {
      for (double t = 0.0; t <= 1.0; t += 0.125) {
        glm::dvec2 outside = glm::abs(at(from, curve, t) - glm::dvec2(6, 5)) - (glm::dvec2(5, 3) - radius);
        double distance = glm::length(glm::max(outside, 0.0)) + std::min(std::max(outside.x, outside.y), 0.0);
        EXPECT_NEAR(distance, radius, 1e-3);
      }
      from = curve.end;
    }
    EXPECT_EQ(from, outline.start);
  }
}

}  // namespace
}  // namespace velum::vector
