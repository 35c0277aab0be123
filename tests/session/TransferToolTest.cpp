#include "session/look/TransferTool.h"

#include <gtest/gtest.h>

#include <cmath>

#include "makeVolume.h"
#include "scene/Scene.h"
#include "session/look/ValueHistogram.h"

namespace velum::session {
namespace {

scene::TransferFunction sample() {
  scene::TransferFunction transfer;
  transfer.colors = {{0, {0, 0, 0}}, {100, {1, 0.5f, 0}}};
  transfer.opacities = {{20, 0}, {40, 0.5}, {80, 1}};
  return transfer;
}

const CurveFrame kFrame{{10, 20}, {200, 100}, {0, 100}, 0.5};

TEST(TransferTool, AddingAPointOnTheLineChangesNothing) {
  auto before = sample(), after = before;
  for (double value : {5.0, 20.0, 31.0, 62.5, 99.0}) {
    int index = addPoint(after.opacities, value, scene::opacityAt(after.opacities, value));
    EXPECT_EQ(after.opacities[std::size_t(index)].value, value);
    addStop(after.colors, value);
  }
  EXPECT_TRUE(std::is_sorted(after.opacities.begin(), after.opacities.end(),
                             [](const auto& a, const auto& b) { return a.value < b.value; }));
  for (double value = -10; value < 120; value += 0.7) {
    EXPECT_NEAR(scene::opacityAt(before.opacities, value), scene::opacityAt(after.opacities, value), 1e-12) << value;
    EXPECT_LT(glm::length(scene::colorAt(before.colors, value) - scene::colorAt(after.colors, value)), 1e-6) << value;
  }
}

TEST(TransferTool, APointStaysBetweenItsNeighboursAndInRange) {
  auto curve = sample().opacities;
  movePoint(curve, 1, 500, 2.0);
  EXPECT_EQ(curve[1], (scene::OpacityPoint{80, 1.0}));
  movePoint(curve, 1, -500, -2.0);
  EXPECT_EQ(curve[1], (scene::OpacityPoint{20, 0.0}));
  movePoint(curve, 2, 1e6, 0.3);
  EXPECT_EQ(curve[2].value, 1e6);
  movePoint(curve, 7, 0, 0);  // none
  auto stops = sample().colors;
  moveStop(stops, 0, 150);
  EXPECT_EQ(stops[0].value, 100);
}

TEST(TransferTool, TheLastPointStays) {
  Curve curve{{1, 0.5}};
  EXPECT_FALSE(removePoint(curve, 0));
  EXPECT_EQ(curve.size(), 1u);
  Stops stops{{1, {}}, {2, {}}};
  EXPECT_FALSE(removeStop(stops, 2));
  EXPECT_TRUE(removeStop(stops, 0));
  EXPECT_FALSE(removeStop(stops, 0));
}

TEST(TransferTool, ShiftAndStretchKeepTheShape) {
  auto before = sample(), after = before;
  shiftTransfer(after, 12.5);
  stretchTransfer(after, 50, 2.0);
  for (double value = -10; value < 120; value += 0.7) {
    double moved = 50 + (value + 12.5 - 50) * 2.0;
    EXPECT_NEAR(scene::opacityAt(before.opacities, value), scene::opacityAt(after.opacities, moved), 1e-9);
    EXPECT_LT(glm::length(scene::colorAt(before.colors, value) - scene::colorAt(after.colors, moved)), 1e-6);
  }
  stretchTransfer(after, 50, 0.5);
  shiftTransfer(after, -12.5);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(after.opacities[i].value, before.opacities[i].value, 1e-12);
}

TEST(TransferTool, OpacitiesScaleUpToOne) {
  auto transfer = sample();
  scaleOpacity(transfer, 1.5);
  EXPECT_EQ(transfer.opacities[1].opacity, 0.75);
  EXPECT_EQ(transfer.opacities[2].opacity, 1.0);
}

TEST(TransferTool, PixelsAndValuesAreInverse) {
  for (double value : {0.0, 33.3, 100.0}) EXPECT_NEAR(valueAtX(kFrame, xOf(kFrame, value)), value, 1e-9);
  for (double opacity : {0.0, 0.004, 0.3, 1.0}) EXPECT_NEAR(opacityAtY(kFrame, yOf(kFrame, opacity)), opacity, 1e-9);
  EXPECT_EQ(yOf(kFrame, 1.0), 20);
  EXPECT_EQ(yOf(kFrame, 0.0), 120);
  EXPECT_EQ(yOf(kFrame, 0.25), 70);  // heights are roots
}

TEST(TransferTool, ThePointerMeetsPointsThenTheLineThenTheArea) {
  auto curve = sample().opacities;
  auto at = [&](double value, double opacity, double up = 0) {
    return hitCurve(kFrame, curve, {xOf(kFrame, value), yOf(kFrame, opacity) - up}, 6.0);
  };
  EXPECT_EQ(at(40, 0.5).index, 1);
  EXPECT_EQ(at(40, 0.5, 5).part, CurveHit::Part::Point);
  EXPECT_EQ(at(60, 0.75).part, CurveHit::Part::Line);
  EXPECT_EQ(at(60, 0.75, 20).part, CurveHit::Part::Nothing);
  EXPECT_EQ(at(60, 0.75, -30).part, CurveHit::Part::Area);
  EXPECT_EQ(at(95, 1.0).part, CurveHit::Part::Line);  // beyond the last point
  EXPECT_EQ(hitCurve(kFrame, curve, {xOf(kFrame, 60), 500}, 6.0).part, CurveHit::Part::Nothing);
  // Of two points that are near, the nearer.
  curve = {{40, 0.5}, {42, 0.5}};
  EXPECT_EQ(at(41.8, 0.5).index, 1);
  EXPECT_EQ(hitStop(kFrame, sample().colors, xOf(kFrame, 98), 6.0), 1);
  scene::TransferFunction close;
  close.colors = {{40, {0, 0, 0}}, {42, {1, 1, 1}}};
  EXPECT_EQ(hitStop(kFrame, close.colors, xOf(kFrame, 40.2), 6.0), 0);
  EXPECT_EQ(hitStop(kFrame, close.colors, xOf(kFrame, 41.8), 6.0), 1);
  EXPECT_EQ(hitStop(kFrame, sample().colors, xOf(kFrame, 50), 6.0), -1);
}

TEST(TransferTool, TheOutlineShowsEveryCorner) {
  auto curve = sample().opacities;
  curve.insert(curve.begin() + 1, {{30.123, 0.9}, {30.123, 0.1}});  // a step between pixels
  auto line = outlineOf(kFrame, curve);
  for (const auto& point : curve) {
    double nearest = 1e9;
    for (auto p : line)
      nearest = std::min(nearest, glm::length(p - glm::dvec2(xOf(kFrame, point.value), yOf(kFrame, point.opacity))));
    EXPECT_LT(nearest, 1e-9);
  }
  EXPECT_EQ(line.front().x, 10);
  EXPECT_EQ(line.back().x, 210);
  for (std::size_t i = 1; i < line.size(); ++i) EXPECT_GE(line[i].x, line[i - 1].x);
}

TEST(TransferTool, ZoomKeepsTheValueUnderThePointerAndTheWholeInSight) {
  AxisView whole{-1000, 3000};
  AxisView view = zoomAxis(whole, 200, 0.5, whole);
  EXPECT_NEAR((200 - view.low) / (view.high - view.low), 0.3, 1e-12);
  EXPECT_NEAR(view.high - view.low, 2000, 1e-9);
  EXPECT_EQ(zoomAxis(view, 200, 100, whole), whole);
  AxisView small = view;
  for (int i = 0; i < 200; ++i) small = zoomAxis(small, 200, 0.5, whole);
  EXPECT_GT(small.high, small.low);
  AxisView moved = panAxis(view, 1e9, whole);
  EXPECT_EQ(moved.high, 3000);
  EXPECT_NEAR(moved.high - moved.low, 2000, 1e-9);
}

TEST(TransferTool, TicksAreRoundFewAndInside) {
  for (AxisView view : {AxisView{-1024, 3071}, AxisView{0, 1}, AxisView{0.0031, 0.0042}, AxisView{1e6, 1.0001e6}}) {
    auto ticks = axisTicks(view, 6);
    EXPECT_GE(ticks.size(), 2u);
    EXPECT_LE(ticks.size(), 6u);
    for (double tick : ticks) EXPECT_TRUE(tick >= view.low - 1e-9 && tick <= view.high * (1 + 1e-9)) << tick;
  }
  EXPECT_EQ(axisTicks({-1024, 3071}, 6), (std::vector<double>{-1000, 0, 1000, 2000, 3000}));
  EXPECT_EQ(axisNumber(-0.2, {-1000, 1000}), "0");
  EXPECT_EQ(axisNumber(250, {0, 1000}), "250");
  EXPECT_EQ(axisNumber(0.25, {0, 1}), "0.25");
}

TEST(ValueHistogram, WholeNumbersHaveABinEach) {
  Volume v = makeVolume({16, 16, 16}, SampleType::Int16, [](glm::ivec3 p) { return p.x - 8; });
  Histogram histogram = valueHistogram(v, 0, 0);
  ASSERT_EQ(histogram.counts.size(), 16u);
  for (auto count : histogram.counts) EXPECT_EQ(count, 256u);
}

TEST(ValueHistogram, GradientsArePerMillimetre) {
  // 3 a voxel of 0.5 mm along y alone, in an oblique frame.
  glm::ivec3 dims(12, 20, 9);
  Volume v = makeVolume(
      dims, SampleType::Float32, [](glm::ivec3 p) { return 3.0 * p.y; }, centredFrame(dims, {1, 0.5, 2}, 0.7));
  Histogram histogram = gradientHistogram(v, 0, 0);
  EXPECT_NEAR(histogram.range.y, 6.0, 1e-4);
  EXPECT_GT(histogram.counts.back(), std::uint64_t(12 * 20 * 9 * 99 / 100));
}

TEST(ValueHistogram, AHugePeakDoesNotFlattenTheRest) {
  Histogram histogram{std::vector<std::uint64_t>(100, 50), {0, 100}};
  histogram.counts[3] = 1'000'000;
  for (bool logarithmic : {false, true}) {
    auto heights = histogramHeights(histogram, {0, 100}, 100, logarithmic);
    EXPECT_EQ(heights[3], 1.0);
    EXPECT_GT(heights[60], 0.25) << logarithmic;
    EXPECT_LT(heights[60], 0.5);
  }
  // Beyond the data there is nothing; between bins a column stands for its share.
  auto wide = histogramHeights(histogram, {-100, 200}, 300, true);
  EXPECT_EQ(wide[50], 0.0);
  EXPECT_EQ(wide[250], 0.0);
  EXPECT_GT(wide[150], 0.0);
  auto near = histogramHeights(histogram, {50, 51}, 40, true);
  for (double height : near) EXPECT_EQ(height, near[0]);
}

TEST(ValueHistogram, TheFirstViewLeavesOutStrayVoxels) {
  Volume v = makeVolume({40, 40, 40}, SampleType::Float32,
                        [](glm::ivec3 p) { return p == glm::ivec3(3) ? 1e5 : 100.0 * hashNoise(p); });
  scene::TransferFunction transfer;
  transfer.opacities = {{-500, 0}, {150, 1}};
  AxisView view = defaultView(valueHistogram(v, 0, 0), transfer);
  EXPECT_LT(view.high, 1000);
  EXPECT_GE(view.high, 150);  // the points in range are seen
  EXPECT_GT(view.low, -100);
}

}  // namespace
}  // namespace velum::session
