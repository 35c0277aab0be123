#include "render/upload/TransferTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "makeVolume.h"
#include "scene/Scene.h"
#include "shared/frame.h"

namespace velum::render {
namespace {

constexpr glm::dvec2 kData(-1000.0, 3000.0);

scene::Scene sceneWith(std::vector<scene::OpacityPoint> points) {
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(makeVolume({2, 1, 1}, SampleType::Int16, [](glm::ivec3 p) { return kData[p.x]; }));
  scene.volume.transfer.opacities = std::move(points);
  return scene;
}

/// What the shaders read for a value: in floats, as they do.
double opacityIn(const TransferTable& table, double value) {
  const float last = float(shared::kTransferSize - 1);
  auto width = float(table.domain.y - table.domain.x);
  float x = float(value) / width * last + float(-table.domain.x) / width * last;
  auto entry = std::size_t(std::clamp(x, 0.0f, last));
  double sum = table.extinctionSums[entry + 1] - table.extinctionSums[entry];
  return 1.0 - std::exp(-sum * table.extinctionUnit);
}

/// Between two positions of a table.
double stepOf(const TransferTable& table) { return (table.domain.y - table.domain.x) / (shared::kTransferSize - 1); }

}  // namespace

TEST(TransferTable, NothingIsDrawnUpToTheFirstPointOfARamp) {
  for (double first : {-1000.0, -1000.5, -700.0, 30.0, 149.7, 2400.0}) {
    TransferTable table = makeTransferTable(sceneWith({{first, 0}, {first + 60, 0.9}, {3000, 0.9}}));
    for (double value : {-1000.0, -400.0, 30.0, first - 1.0, first})
      if (value <= first) {
        EXPECT_EQ(opacityIn(table, value), 0.0) << value << " below " << first;
      }
    EXPECT_GT(table.shownFrom, 0) << "else no cell of air would be empty";
    EXPECT_GT(opacityIn(table, first + 2.0 * stepOf(table)), 0.0);
  }
}

TEST(TransferTable, BelowItsFirstPointACurveGoesOnAsThatSays) {
  TransferTable table = makeTransferTable(sceneWith({{-200, 0.4}, {100, 0.0}, {200, 0.7}}));
  for (double value : {-1000.0, -300.0, -200.0}) EXPECT_NEAR(opacityIn(table, value), 0.4, 1e-6) << value;
  for (double value : {200.0, 201.0, 3000.0}) EXPECT_NEAR(opacityIn(table, value), 0.7, 1e-6) << value;
}

TEST(TransferTable, AStepAtTheFirstPointHasNothingBelowAndAllFromThereOn) {
  for (double first : {-1000.0, -300.0, 120.0}) {
    TransferTable table = makeTransferTable(sceneWith({{first, 0}, {first, 0.6}, {2000, 0.6}}));
    for (double below : {300.0, 5.0, 1.5}) {
      EXPECT_EQ(opacityIn(table, first - below), 0.0) << first << " - " << below;
    }
    for (double value : {first, first + 1.0, 1500.0}) EXPECT_NEAR(opacityIn(table, value), 0.6, 1e-6) << value;
  }
}

TEST(TransferTable, BetweenThePointsItIsTheCurveWithinAnEntry) {
  std::vector<scene::OpacityPoint> points{{-400, 0}, {100, 0.3}, {250, 0.05}, {900, 0.8}};
  TransferTable table = makeTransferTable(sceneWith(points));
  EXPECT_EQ(table.domain.y, 900.0);
  EXPECT_NEAR(table.domain.x, -400.0, 2.0 * stepOf(table));
  for (double value = -395.0; value < 900.0; value += 1.7) {
    double steepest = 0.25 / 150.0 * 1.2;  // of the curve, in opacity a value
    EXPECT_NEAR(opacityIn(table, value), scene::opacityAt(points, value), 1.5 * steepest * stepOf(table)) << value;
  }
}

}  // namespace velum::render
