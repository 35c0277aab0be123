#include "vector/TraceParts.h"

#include <gtest/gtest.h>

#include "TracedPictures.h"
#include "vector/Strokes.h"

namespace velum::vector {
namespace {

/// Parts as an orthographic camera sees them, in a picture of 1000 rows or less.
struct Parts {
  Picture picture;
  std::vector<float> depths, sizes;
  std::vector<int> groups;
  PartMap map() const { return {picture.size, picture.ids, depths, sizes, groups}; }
};

Parts partsOf(glm::ivec2 size, const std::function<int(glm::dvec2)>& idAt,
              const std::function<double(glm::dvec2)>& depthAt, double across, std::vector<int> groups) {
  Parts parts{paint(size, idAt), {}, {}, std::move(groups)};
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      parts.depths.push_back(float(depthAt({x + 0.5, y + 0.5})));
      parts.sizes.push_back(float(across));
    }
  return parts;
}

PartOptions options() {
  PartOptions options;
  options.width = 4.0;
  options.stepLength = 10.0;
  options.deepStep = 50.0;
  return options;
}

std::vector<Stroke> trace(const Parts& parts, const PartOptions& how = options()) {
  Progress progress;
  return traceParts(parts.map(), how, progress);
}

/// The width of the strokes that pass a place, in the finish's width; 0: none does.
double widthAt(const std::vector<Stroke>& strokes, glm::dvec2 place, double within = 1.0) {
  double width = 0.0;
  for (const Stroke& stroke : strokes)
    walkAlong(stroke.line, 0.25, [&](glm::dvec2 p) {
      if (glm::distance(p, place) < within) width = std::max(width, kWidestPartLine * stroke.strength);
    });
  return width;
}

constexpr double kClass = kWidestPartLine / 16.0;  // widths are in sixteenths

/// Four stripes that fill the picture: of one compartment, of another, and one that lies deep.
Parts stripes(double across) {
  auto idAt = [](glm::dvec2 p) { return p.y < 40 || p.y > 360 ? 0 : 1 + int(p.x) / 100; };
  auto depthAt = [](glm::dvec2 p) { return p.x > 300 ? 1200.0 : 1000.0; };
  return partsOf({400, 400}, idAt, depthAt, across, {1, 1, 2, 2});
}

TEST(TraceParts, EachKindOfBorderHasItsWeight) {
  std::vector<Stroke> strokes = trace(stripes(300.0));
  EXPECT_NEAR(widthAt(strokes, {100, 200}), 0.85, kClass) << "two instances";
  EXPECT_NEAR(widthAt(strokes, {200, 200}), 0.7 * 1.6 + 0.3 * 0.85, kClass) << "two compartments";
  EXPECT_NEAR(widthAt(strokes, {300, 200}), 1.6, kClass) << "a deep step";
  EXPECT_NEAR(widthAt(strokes, {50, 40}), 1.6, kClass) << "the outline of all";
  EXPECT_EQ(widthAt(strokes, {50, 200}), 0.0) << "nothing";
  EXPECT_EQ(widthAt(strokes, {0.5, 200}), 0.0) << "the edge of the picture";
}

TEST(TraceParts, LinesGoAsInstancesBecomeSmall) {
  double last = 1.0;
  for (double across : {200.0, 25.0, 13.0, 9.0, 5.0}) {
    double width = widthAt(trace(stripes(across)), {100, 200});
    EXPECT_LT(width, last) << across;
    last = width;
  }
  EXPECT_EQ(last, 0.0);
  std::vector<Stroke> small = trace(stripes(5.0));
  EXPECT_GT(widthAt(small, {200, 200}), 0.0) << "compartments keep a line";
  EXPECT_GT(widthAt(small, {50, 40}, 2.0), 0.0) << "and so does the whole";
}

TEST(TraceParts, StrengthsOfTheFinishCount) {
  PartOptions how = options();
  how.structures = 0.5;
  std::vector<Stroke> strokes = trace(stripes(300.0), how);
  EXPECT_NEAR(widthAt(strokes, {100, 200}), 0.5 * 0.85, kClass);
  EXPECT_NEAR(widthAt(strokes, {300, 200}), 1.6, kClass);
  how.steps = how.structures = 0.0;
  EXPECT_TRUE(trace(stripes(300.0), how).empty());
}

TEST(TraceParts, ALineBelongsToWhoIsInFront) {
  auto idAt = [](glm::dvec2 p) { return glm::distance(p, {150, 150}) < 60 ? 2 : 1; };
  auto depthAt = [](glm::dvec2 p) { return glm::distance(p, {150, 150}) < 60 ? 900.0 : 1000.0; };
  std::vector<Stroke> strokes = trace(partsOf({300, 300}, idAt, depthAt, 300.0, {1, 1}));
  ASSERT_EQ(strokes.size(), 1u);
  EXPECT_EQ(strokes[0].id, 2);
  EXPECT_TRUE(strokes[0].line.isClosed);
  walkAlong(strokes[0].line, 0.5, [](glm::dvec2 p) { EXPECT_NEAR(glm::distance(p, {150, 150}), 60.0, 0.5); });
}

TEST(TraceParts, ALineLiesInTheMiddleOfItsBand) {
  // Inside a small part the pen is the finest, outside it is as wide as is asked for: a band from the one half width to
  // the other.
  auto idAt = [](glm::dvec2 p) { return glm::distance(p, {150, 150}) < 60 ? 1 : 0; };
  std::vector<Stroke> strokes = trace(partsOf({300, 300}, idAt, [](glm::dvec2) { return 1.0; }, 16.0, {1}));
  ASSERT_EQ(strokes.size(), 1u);
  double inside = 0.5 * 1.6 * 0.65, outside = 0.5 * 1.6 * 4.0;
  EXPECT_NEAR(strokes[0].strength * 1.6 * 4.0, inside + outside, 1.6 * 4.0 / 16.0);
  walkAlong(strokes[0].line, 0.5, [&](glm::dvec2 p) {
    EXPECT_NEAR(glm::distance(p, {150, 150}), 60.0 + 0.5 * (outside - inside), 0.55);
  });
}

TEST(TraceParts, FoldsWithinLargePartsAreFaint) {
  auto depthAt = [](glm::dvec2 p) { return p.x < 150.0 ? 1000.0 : 1040.0; };
  auto idAt = [](glm::dvec2) { return 1; };
  std::vector<Stroke> strokes = trace(partsOf({300, 300}, idAt, depthAt, 300.0, {1}));
  EXPECT_NEAR(widthAt(strokes, {150, 150}), 0.27 * 0.85, kClass);
  EXPECT_TRUE(trace(partsOf({300, 300}, idAt, depthAt, 20.0, {1})).empty()) << "small ones have none";
  auto slope = [](glm::dvec2 p) { return 1000.0 + 5.0 * p.x; };
  EXPECT_TRUE(trace(partsOf({300, 300}, idAt, slope, 300.0, {1})).empty()) << "nor have slopes";
}

TEST(Strokes, PiecesOfACircleAreJoinedToOneThatIsClosed) {
  Outline whole = circle({50, 50}, 30);
  std::vector<Stroke> pieces;
  glm::dvec2 from = whole.start;
  for (std::size_t i = 0; i < whole.curves.size(); ++i) {
    Outline piece{from, {whole.curves[i]}, false};
    if (i % 2 == 1) piece = {whole.curves[i].end, {{whole.curves[i].control2, whole.curves[i].control1, from}}, false};
    pieces.push_back({piece, 0.5, 3});
    from = whole.curves[i].end;
  }
  std::vector<Stroke> joined = joinedStrokes(pieces);
  ASSERT_EQ(joined.size(), 1u);
  EXPECT_TRUE(joined[0].line.isClosed);
  EXPECT_EQ(joined[0].line.curves.size(), 4u);
  walkAlong(joined[0].line, 0.5, [](glm::dvec2 p) { EXPECT_NEAR(glm::distance(p, {50, 50}), 30.0, 0.05); });
  pieces[1].strength = 1.0;
  EXPECT_EQ(joinedStrokes(pieces).size(), 2u) << "another weight is another stroke";
  pieces.push_back({{pieces[0].line.start, {straight(pieces[0].line.start, {99, 99})}, false}, 0.5, 3});
  EXPECT_EQ(joinedStrokes(pieces).size(), 4u) << "where three meet all end";
}

TEST(Strokes, ALineMovedAcrossItselfKeepsItsShape) {
  for (double by : {-4.0, 3.0}) {
    Outline line = circle({50, 50}, 30);
    moveAcross(line, [&](glm::dvec2, glm::dvec2) { return by; });
    double radius = glm::distance(line.start, {50, 50});
    EXPECT_NEAR(std::abs(radius - 30.0), std::abs(by), 0.005);
    walkAlong(line, 0.5, [&](glm::dvec2 p) { EXPECT_NEAR(glm::distance(p, {50, 50}), radius, 0.05); });
  }
}

}  // namespace
}  // namespace velum::vector
