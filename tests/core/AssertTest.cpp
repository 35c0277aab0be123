#include "core/Assert.h"

#include <gtest/gtest.h>

namespace velum {
namespace {

TEST(Assert, NothingHappensWhereItHolds) {
  int looks = 0;
  VELUM_ASSERT(++looks > 0, "it looks");
  EXPECT_LE(looks, 1);  // none in a release build
}

#if !defined(NDEBUG) || defined(VELUM_ASSERTS)
TEST(AssertDeathTest, WhatDoesNotHoldIsNamedWithItsPlace) {
  EXPECT_DEATH(VELUM_ASSERT(1 + 1 == 3, "sums come out"), "AssertTest.cpp:[0-9]+: .*sums come out.*1 \\+ 1 == 3");
}
#endif

}  // namespace
}  // namespace velum
