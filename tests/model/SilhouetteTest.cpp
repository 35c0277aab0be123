#include "model/Silhouette.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace velum::model
