#include "session/extrusion/Populations.h"

#include <gtest/gtest.h>

#include <random>

namespace velum::session {
namespace {

class Populations : public testing::Test {
 protected:
  void add(double middle, double spread, int count) {
    std::normal_distribution<double> values(middle, spread);
    for (int i = 0; i < count; ++i) mValues.push_back(values(mRandom));
  }
  std::mt19937 mRandom{3};
  std::vector<double> mValues;
};

TEST_F(Populations, AreThePeaksOfWhatTheyWereMadeOf) {
  add(-100, 20, 6000);
  add(50, 15, 20000);
  add(480, 40, 9000);
  auto found = populationsOf(mValues);
  ASSERT_EQ(found.size(), 3u);
  const double wanted[][2] = {{-100, 20}, {50, 15}, {480, 40}};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(found[i].middle, wanted[i][0], 0.4 * wanted[i][1]);
    EXPECT_NEAR(found[i].spread, wanted[i][1], 0.25 * wanted[i][1]);
  }
  EXPECT_NEAR(found[1].share, 20.0 / 35.0, 0.02);
  EXPECT_TRUE(found[2].holds(500));
  EXPECT_FALSE(found[2].holds(300));
}

TEST_F(Populations, ATailIsNoPeakOfItsOwn) {
  add(50, 15, 30000);
  for (int i = 0; i < 4000; ++i) mValues.push_back(60.0 + std::exponential_distribution<double>(0.004)(mRandom));
  auto found = populationsOf(mValues);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].middle, 50.0, 6.0);
  EXPECT_LT(found[0].upperEnd(), 130.0) << "the tail does not make it wider";
}

TEST_F(Populations, SmallOnesAreLeftOut) {
  add(10, 3, 30000);
  add(90, 3, 900);
  EXPECT_EQ(populationsOf(mValues).size(), 1u);
}

TEST_F(Populations, OfOneValueThereIsOneAndOfNoneNone) {
  EXPECT_TRUE(populationsOf({}).empty());
  auto one = populationsOf({7.0, 7.0, 7.0});
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].middle, 7.0);
  EXPECT_TRUE(one[0].holds(7.0));
}

TEST_F(Populations, AreTheSameInAnotherUnit) {
  add(50, 15, 20000);
  add(480, 40, 9000);
  auto found = populationsOf(mValues);
  for (double& value : mValues) value = 1e-6 * value - 3.0;
  auto scaled = populationsOf(mValues);
  ASSERT_EQ(found.size(), scaled.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(scaled[i].middle, 1e-6 * found[i].middle - 3.0, 2e-6) << "two bins";
}

}  // namespace
}  // namespace velum::session
