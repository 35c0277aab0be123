// A whole model as one thing that is seen from afar.
#include "model/WholeModel.h"

#include <gtest/gtest.h>

#include "makeModel.h"
#include "model/Levels.h"

namespace velum {
namespace {

model::WholeModel wholeOf(const Model& model) {
  Progress progress;
  return model::makeWholeModel(model, model::computeLevels(model, progress));
}

TEST(WholeModel, EndsWithABallAndEachLevelHasFewer) {
  ModelMaker maker;
  maker.instances = 3000;
  Model model = maker.make();
  auto whole = wholeOf(model);
  ASSERT_GT(whole.levels.size(), 5u);
  EXPECT_EQ(whole.levels.back().count, 1u);
  for (std::size_t i = 1; i < whole.levels.size(); ++i) {
    EXPECT_LT(whole.levels[i].count, whole.levels[i - 1].count);
    EXPECT_GT(whole.levels[i].error, whole.levels[i - 1].error);
    EXPECT_EQ(whole.levels[i].first, whole.levels[i - 1].first + whole.levels[i - 1].count);
  }
  for (const auto& ball : whole.balls)
    EXPECT_TRUE(glm::all(glm::greaterThanEqual(ball.centre, model.low - 1e-2f)) &&
                glm::all(glm::lessThanEqual(ball.centre, model.high + 1e-2f)));
}

TEST(WholeModel, ShowsTypesInProportionToTheirAreas) {
  // Three types of the same size: a third of the balls each, level by level, whoever stands where.
  ModelMaker maker;
  maker.instances = 9000;
  auto whole = wholeOf(maker.make());
  for (const Level& level : whole.levels) {
    if (level.count < 500) break;
    std::array<int, 3> counts{};
    for (std::uint32_t i = level.first; i < level.first + level.count; ++i) ++counts[whole.balls[i].type];
    // Four standard deviations.
    double wanted = level.count / 3.0, off = 4.0 * std::sqrt(level.count * 2.0 / 9.0);
    for (int count : counts) EXPECT_NEAR(count, wanted, off) << level.count << " balls";
  }
}

TEST(WholeModel, OfOneBallIsThatBall) {
  auto whole = wholeOf(modelOfAtoms({{5, 6, 7}}));
  ASSERT_EQ(whole.levels.size(), 1u);
  EXPECT_NEAR(glm::length(whole.balls.front().centre - glm::vec3(5, 6, 7)), 0.0f, 1e-4f);
}

}  // namespace
}  // namespace velum
