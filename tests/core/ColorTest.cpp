#include "core/Color.h"

#include <gtest/gtest.h>

namespace velum {
namespace {

TEST(Color, LinearSharesAndBackAreTheSame) {
  for (double share = -1.0; share <= 1.0; share += 1.0 / 64)
    EXPECT_NEAR(srgbFromLinear(linearFromSrgb(share)), share, 1e-6) << share;
}

TEST(Color, MiddleGreyIsAFifthOfTheLight) {
  EXPECT_NEAR(linearFromSrgb(0.5), 0.2140, 1e-4);
  EXPECT_NEAR(linearFromSrgb(-0.5f), -0.2140f, 1e-4f);
  EXPECT_DOUBLE_EQ(linearFromSrgb(1.0), 1.0);
}

}  // namespace
}  // namespace velum
