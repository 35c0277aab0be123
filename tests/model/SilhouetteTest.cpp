#include "model/Silhouette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace velum::model {
namespace {

TEST(Silhouette, IsAsFarFromAnotherAsEitherLacksOfIt) {
  const std::vector<Ball> both{{{0, 0, 0}, 10.0f}, {{30, 0, 0}, 4.0f}};
  const std::vector<Ball> one{both.front()};
  Silhouette whole({0, 0, 1}, both, 0.5f), part = whole.blank();
  whole.add(both);
  part.add(one);
  // What lacks the small ball must grow by its far side to hold it; the other way nothing is lacking.
  EXPECT_NEAR(distanceBetween(whole, part), 24.0f, 2.5f);
  EXPECT_NEAR(distanceBetween(part, whole), 24.0f, 2.5f);
  EXPECT_NEAR(distanceBetween(whole, whole), 0.25f, 1e-6f) << "half a pixel at least";
}

/// Balls that lie behind others are passed over; which come first is no matter.
TEST(Silhouette, DoesNotDependOnTheOrderOfItsBalls) {
  std::vector<Ball> balls;
  for (int i = 0; i < 400; ++i) {
    float a = 2.39996323f * float(i), r = 0.09f * float(i);
    balls.push_back({{r * std::cos(a), r * std::sin(a), float(i % 7)}, 1.0f + 0.01f * float(i % 90)});
  }
  Silhouette forwards({0, 0, 1}, balls, 0.5f), backwards = forwards.blank();
  forwards.add(balls);
  std::reverse(balls.begin(), balls.end());
  backwards.add(balls);
  EXPECT_NEAR(distanceBetween(forwards, backwards), 0.25f, 1e-6f) << "the same";
}

}  // namespace
}  // namespace velum::model
