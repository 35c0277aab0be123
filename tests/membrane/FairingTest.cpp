#include "membrane/sheet/Fairing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "membrane/sheet/SheetIndex.h"
#include "membrane/sheet/Simulation.h"
#include "scene/Scene.h"

/// The refined sheet against closed forms of the obstacle problem.
namespace velum::membrane {
namespace {

constexpr double kHalf = 40.0;

std::vector<float> places(int count) {
  std::vector<float> all;
  for (int i = 0; i < count; ++i) all.push_back(float(kHalf * (2.0 * i / (count - 1) - 1.0)));
  return all;
}

/// A sheet of particles a millimetre apart over the highest of `floor` and below `ceiling`, both functions of a place.
template <class Floor, class Ceiling>
HeightOver sheetBetween(Floor floor, Ceiling ceiling, double pullLength, HeightOver rest = {}) {
  Fairing::Input input;
  input.xs = input.ys = places(81);
  input.reach = 30.0;
  input.pullLength = pullLength;
  input.rest = std::move(rest);
  input.corridor.dims = {81, 81};
  input.corridor.origin = glm::dvec2(-kHalf);
  for (float y : input.ys)
    for (float x : input.xs) {
      input.corridor.room.emplace_back(floor(double(x), double(y)), ceiling(double(x), double(y)));
      input.corridor.height.push_back(0.0f);
    }
  Fairing fairing(std::move(input));
  while (fairing.sweep()) {
  }
  return heightOf(fairing.shape());
}

float none(double, double) { return -30.0f; }
float open(double, double) { return 30.0f; }

TEST(Fairing, BetweenARidgeAndTheFrameItIsNoHigherThanAStraightLine) {
  // A steep one: the shortest way is straight whatever the slope, and the frame beside its ends draws it down.
  for (bool alongX : {true, false}) {
    auto ridge = [=](double x, double y) { return std::abs(alongX ? y : x) < 0.5 ? 24.0f : -30.0f; };
    HeightOver height = sheetBetween(ridge, open, 0.0);
    for (double t : {5.0, 10.0, 15.0})
      EXPECT_LT(height(alongX ? glm::dvec2(0, t) : glm::dvec2(t, 0)), 24.0 * (1.0 - t / kHalf) + 0.5) << t;
    EXPECT_GT(height(alongX ? glm::dvec2(0, 5) : glm::dvec2(5, 0)), 14.0);
  }
}

TEST(Fairing, BesideAWallItFallsBackToAThirdWithinThePullLength) {
  // h'' = (h - 1) / length^2 beside a low wall at x = 0: h = 1 + (h0 - 1) exp(-x / length). Low, so that areas are
  // squared slopes.
  constexpr double kLength = 6.0;
  auto wall = [](double x, double) { return std::abs(x) < 0.5 ? 2.0f : -30.0f; };
  HeightOver height = sheetBetween(wall, open, kLength, [](glm::dvec2) { return 1.0; });
  for (double x : {3.0, 6.0, 12.0}) {
    EXPECT_NEAR(height({x, 0}), 1.0 + std::exp(-x / kLength), 0.03) << x;
    EXPECT_NEAR(height({-x, 0}), 1.0 + std::exp(-x / kLength), 0.03) << x;
  }
}

TEST(Fairing, StaysInItsRoom) {
  auto floor = [](double x, double y) { return std::hypot(x - 15, y) < 6 ? 9.0f : -30.0f; };
  auto ceiling = [](double x, double y) { return std::hypot(x + 15, y) < 6 ? -7.0f : 30.0f; };
  HeightOver height = sheetBetween(floor, ceiling, 8.0);
  EXPECT_GE(height({15, 0}), 9.0 - 1e-5);
  EXPECT_LE(height({-15, 0}), -7.0 + 1e-5);
  EXPECT_NEAR(height({15, 0}), 9.0, 1e-4) << "and no farther than it must";
  EXPECT_NEAR(height({-15, 0}), -7.0, 1e-4);
  EXPECT_EQ(height({kHalf, 3}), 0.0) << "it hangs in its frame";
}

TEST(Fairing, AroundACapItIsRoundWhateverTheDirection) {
  // No peaks at the axes: heights and slopes on a circle are those of every direction.
  auto cap = [](double x, double y) { return float(14.0 - 0.05 * (x * x + y * y)); };
  HeightOver height =
      sheetBetween([&](double x, double y) { return std::hypot(x, y) < 8 ? cap(x, y) : -30.0f; }, open, 7.0);
  for (double radius : {11.0, 15.0, 20.0}) {
    double low = 1e30, high = -1e30;
    for (int degrees = 0; degrees < 360; degrees += 15) {
      double z =
          height(radius * glm::dvec2(std::cos(glm::radians(double(degrees))), std::sin(glm::radians(double(degrees)))));
      low = std::min(low, z);
      high = std::max(high, z);
    }
    EXPECT_GT(low, 0.05);
    EXPECT_LT(high - low, 0.05 * high + 0.05) << radius;
  }
}

TEST(Fairing, PassesStakesThatStandBetweenItsParticles) {
  // A wavy field of stakes to either side of a surface that no row or column of particles meets.
  Fairing::Input input;
  input.xs = input.ys = places(81);
  input.reach = 30.0;
  input.pullLength = 5.0;
  input.corridor.dims = {81, 81};
  input.corridor.origin = glm::dvec2(-kHalf);
  input.corridor.room.assign(81 * 81, glm::vec2(-30.0f, 30.0f));
  input.corridor.height.assign(81 * 81, 0.0f);
  std::vector<Stake> stakes;
  for (int i = 0; i < 4000; ++i) {
    double x = 35.0 * std::sin(12.9898 * i), y = 35.0 * std::sin(78.233 * i + 1.0);
    double surface = 6.0 * std::sin(0.25 * x) + 4.0 * std::cos(0.3 * y);
    bool isBelow = i % 2 == 0;
    stakes.push_back({glm::vec3(x, y, surface + (isBelow ? -0.6 : 0.6)), isBelow});
  }
  input.corridor.stakes = stakes;
  Fairing fairing(std::move(input));
  auto wrong = [&](const scene::SheetShape& shape) {
    SheetIndex index = makeSheetIndex(shape, glm::ivec2(2), glm::dvec3(2 * kHalf, 2 * kHalf, 60.0));
    return std::count_if(stakes.begin(), stakes.end(),
                         [&](const Stake& stake) { return isAbove(index, stake.place) == stake.isBelow; });
  };
  EXPECT_GT(wrong(fairing.shape()), 1000) << "flat";
  while (fairing.sweep()) {
  }
  EXPECT_EQ(wrong(fairing.shape()), 0);
}

TEST(Fairing, NothingInItsWayLeavesItFlat) {
  HeightOver height = sheetBetween(none, open, 10.0);
  for (double x : {-30.0, 0.0, 17.5}) EXPECT_EQ(height({x, 3.0}), 0.0);
}

TEST(Fairing, IsTheSameEveryTime) {
  auto bumps = [](double x, double y) { return std::sin(0.4 * x) * std::cos(0.3 * y) > 0.6 ? 5.0f : -30.0f; };
  auto once = [&] {
    HeightOver height = sheetBetween(bumps, open, 5.0);
    std::vector<double> heights;
    for (float x : places(50)) heights.push_back(height({x, 0.37 * double(x)}));
    return heights;
  };
  EXPECT_EQ(once(), once());
}

}  // namespace
}  // namespace velum::membrane
