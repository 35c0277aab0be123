#include "scene/TransferFunction.h"

#include <gtest/gtest.h>

namespace velum::scene {
namespace {

TEST(TransferFunction, BeforeTheFirstAndAfterTheLastPointIsWhatTheySay) {
  std::vector<OpacityPoint> opacities{{-100, 0.2}, {50, 0.6}, {300, 0.9}};
  EXPECT_EQ(opacityAt(opacities, -1e9), 0.2);
  EXPECT_EQ(opacityAt(opacities, 300), 0.9);
  EXPECT_EQ(opacityAt(opacities, 1e9), 0.9);
  std::vector<ColorPoint> colors{{0, {1, 0, 0}}, {10, {0, 0, 1}}};
  EXPECT_EQ(colorAt(colors, -5), glm::dvec3(1, 0, 0));
  EXPECT_EQ(colorAt(colors, 15), glm::dvec3(0, 0, 1));
}

TEST(TransferFunction, BetweenTwoPointsItIsStraight) {
  std::vector<OpacityPoint> opacities{{-100, 0.2}, {50, 0.6}, {300, 0.9}};
  EXPECT_DOUBLE_EQ(opacityAt(opacities, -100), 0.2);
  EXPECT_DOUBLE_EQ(opacityAt(opacities, -62.5), 0.3);
  EXPECT_DOUBLE_EQ(opacityAt(opacities, 50), 0.6);
  EXPECT_DOUBLE_EQ(opacityAt(opacities, 250), 0.84);
  std::vector<ColorPoint> colors{{0, {1, 0, 0}}, {10, {0, 0, 1}}};
  EXPECT_LT(glm::length(colorAt(colors, 2.5) - glm::dvec3(0.75, 0, 0.25)), 1e-15);
}

TEST(TransferFunction, TwoPointsAtOneValueAreAStep) {
  std::vector<OpacityPoint> opacities{{0, 0.0}, {10, 0.0}, {10, 1.0}, {20, 1.0}};
  EXPECT_EQ(opacityAt(opacities, 9.999), 0.0);
  EXPECT_EQ(opacityAt(opacities, 10), 1.0);
}

}  // namespace
}  // namespace velum::scene
