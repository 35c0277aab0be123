#include "vector/TraceHatching.h"

#include <gtest/gtest.h>

#include <limits>

#include "SeenSurface.h"
#include "TracedPictures.h"

namespace velum::vector {
namespace {

constexpr double kSpacing = 8.0;

std::vector<Stroke> hatched(const Seen& seen, double tone, bool crosses = false) {
  Progress progress;
  std::vector<float> tones(seen.ids.size(), float(tone));
  return traceHatching(seen.map(), seen.view(), tones, {kSpacing, crosses}, progress);
}

Seen cylinder() {  // upright
  return look({240, 240}, [](glm::dvec2 p) {
    double off = std::abs(p.x - 120.0);
    return off < 100.0 ? std::sqrt(100.0 * 100.0 - off * off) : std::numeric_limits<double>::quiet_NaN();
  });
}

TEST(TraceHatching, StrokesGoRoundACylinderEvenly) {
  std::vector<Stroke> strokes = hatched(cylinder(), 0.5);
  double along = 0.0, across = 0.0;
  std::vector<double> heights;
  for (const Stroke& stroke : strokes) {
    glm::dvec2 last = stroke.line.start;
    walkAlong(stroke.line, 0.5, [&](glm::dvec2 p) {
      along += std::abs(p.x - last.x);
      across += std::abs(p.y - last.y);
      if ((last.x < 120.0) != (p.x < 120.0)) heights.push_back(p.y);
      EXPECT_LT(std::abs(p.x - 120.0), 100.5);  // none beside it
      last = p;
    });
  }
  EXPECT_GT(along, 14.0 * across);
  std::sort(heights.begin(), heights.end());
  ASSERT_GT(heights.size(), 25u);
  for (std::size_t i = 1; i < heights.size(); ++i) EXPECT_NEAR(heights[i] - heights[i - 1], kSpacing, 1.5);
}

TEST(TraceHatching, DarkerPlacesHaveBroaderStrokes) {
  auto meanWidth = [](const std::vector<Stroke>& strokes) {
    double sum = 0.0;
    for (const Stroke& stroke : strokes) sum += stroke.strength;
    return strokes.empty() ? 0.0 : sum / double(strokes.size());
  };
  double light = meanWidth(hatched(cylinder(), 0.7)), dark = meanWidth(hatched(cylinder(), 0.3));
  EXPECT_EQ(meanWidth(hatched(cylinder(), 0.95)), 0.0);
  EXPECT_NEAR(light, (0.3 - 0.16) * 1.05, 0.06);  // as the shader has it
  EXPECT_NEAR(dark, (0.7 - 0.16) * 1.05, 0.06);
}

TEST(TraceHatching, TheDarkestIsCrossed) {
  auto upright = [](const std::vector<Stroke>& strokes) {
    int count = 0;
    for (const Stroke& stroke : strokes) {
      glm::dvec2 way = stroke.line.curves.back().end - stroke.line.start;
      if (std::abs(way.y) > 2.0 * std::abs(way.x)) ++count;
    }
    return count;
  };
  EXPECT_EQ(upright(hatched(cylinder(), 0.05, false)), 0);
  EXPECT_GT(upright(hatched(cylinder(), 0.05, true)), 15);
  EXPECT_EQ(upright(hatched(cylinder(), 0.6, true)), 0);
}

TEST(TraceHatching, StrokesEndAtRegions) {
  Seen seen = cylinder();
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 240; ++x)
      if (int& id = seen.ids[std::size_t(y * 240 + x)]; id == 1 && x >= 130) id = 2;
  for (const Stroke& stroke : hatched(seen, 0.4))
    walkAlong(stroke.line, 0.5, [&](glm::dvec2 p) { EXPECT_EQ(stroke.id, p.x < 130.0 ? 1 : 2) << p.x; });
}

TEST(TraceHatching, PiecesOfAStrokeHangTogether) {
  Seen seen = cylinder();
  Progress progress;
  std::vector<float> tones;
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 240; ++x)
      tones.push_back(float(std::abs(x - 120)) < 100.0f ? 0.2f + 0.006f * float(std::abs(x - 120)) : 1.0f);
  std::vector<Stroke> strokes = traceHatching(seen.map(), seen.view(), tones, {kSpacing, false}, progress);
  int joints = 0;
  for (std::size_t i = 1; i < strokes.size(); ++i)
    joints += glm::distance(strokes[i - 1].line.curves.back().end, strokes[i].line.start) < 1e-9;
  EXPECT_GT(joints, 100);
}

}  // namespace
}  // namespace velum::vector
