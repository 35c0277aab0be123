// A whole model as one thing that is seen from afar.
#include "model/WholeModel.h"

#include <gtest/gtest.h>

#include <algorithm>

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
    // Their molecules are not quite as large, and lots are drawn of what lots have left: a twentieth, and four standard
    // deviations.
    double wanted = level.count / 3.0, off = 0.05 * wanted + 4.0 * std::sqrt(level.count * 2.0 / 9.0);
    for (int count : counts) EXPECT_NEAR(count, wanted, off) << level.count << " balls";
  }
}

TEST(WholeModel, HasForEachSideTheBallsThatAreFirstThere) {
  ModelMaker maker;
  maker.instances = 40000;
  Model model = maker.make();
  auto whole = wholeOf(model);
  ASSERT_EQ(whole.sides.size(), whole.levels.size());
  const Level& level = whole.levels.front();
  auto isSame = [](const model::WholeBall& a, const model::WholeBall& b) { return a.centre == b.centre; };
  for (unsigned octant = 0; octant < 8; ++octant) {
    const Level& side = whole.sides.front()[octant];
    EXPECT_EQ(side.error, level.error);
    EXPECT_LT(side.count, level.count / 2) << "what lies deep, and on the other side, is left out";
    // The ball that lies furthest out towards who looks is never left out.
    glm::vec3 look((octant & 1u) ? 1 : -1, (octant & 2u) ? 1 : -1, (octant & 4u) ? 1 : -1);
    auto depth = [&](const model::WholeBall& ball) { return glm::dot(ball.centre, look); };
    auto first = whole.balls.begin() + level.first, end = first + level.count;
    auto nearest = std::min_element(first, end, [&](const auto& a, const auto& b) { return depth(a) < depth(b); });
    auto sideFirst = whole.balls.begin() + side.first, sideEnd = sideFirst + side.count;
    EXPECT_TRUE(std::any_of(sideFirst, sideEnd, [&](const auto& ball) { return isSame(ball, *nearest); }));
    for (auto ball = sideFirst; ball != sideEnd; ++ball)
      ASSERT_TRUE(std::any_of(first, end, [&](const auto& one) { return isSame(one, *ball); }));
  }
}

TEST(WholeModel, OfOneBallIsThatBall) {
  auto whole = wholeOf(modelOfAtoms({{5, 6, 7}}));
  ASSERT_EQ(whole.levels.size(), 1u);
  for (const Level& side : whole.sides.front()) EXPECT_EQ(side.count, 1u);
  EXPECT_NEAR(glm::length(whole.balls.front().centre - glm::vec3(5, 6, 7)), 0.0f, 1e-4f);
}

}  // namespace
}  // namespace velum
