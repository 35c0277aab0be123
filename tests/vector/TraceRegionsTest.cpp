#include "vector/TraceRegions.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "TracedPictures.h"

namespace velum::vector {
namespace {

// A border that is drawn on pixels lies within half a pixel of their edges, and comes as near to that where it is
// nearly level; a fiftieth more is not worth taking lines apart, and a hundredth is missed.
constexpr double kWorst = 0.53;

RegionMap trace(const Picture& picture, double least = 0.0) {
  Progress progress;
  return traceRegions(picture.map(), {least}, progress);
}

const Region& regionOf(const RegionMap& traced, int id) {
  for (const Region& region : traced.regions)
    if (region.id == id) return region;
  ADD_FAILURE() << "no region " << id;
  static const Region none{};
  return none;
}

/// What holds for every picture: nothing is far from an edge, and what is drawn again differs beside borders alone.
Faults expectLaws(const Picture& picture, const RegionMap& traced, const std::string& what) {
  Faults faults = faultsOf(picture, traced);
  EXPECT_LT(faults.worst, kWorst) << what;
  EXPECT_EQ(faults.wrongInside, 0) << what;
  for (const Region& region : traced.regions)
    for (const Outline& outline : region.outlines) {
      EXPECT_TRUE(outline.isClosed);
      EXPECT_LT(glm::distance(outline.curves.back().end, outline.start), 1e-9) << what;
    }
  return faults;
}

TEST(TraceRegions, CirclesAreRoundOfFewCurves) {
  for (double radius : {5.0, 12.3, 30.0, 50.0, 77.7, 150.0, 600.0}) {
    int size = int(2.0 * radius) + 12;
    glm::dvec2 middle(size / 2.0 + 0.3, size / 2.0 - 0.2);
    Picture picture = paint({size, size}, [&](glm::dvec2 p) { return glm::distance(p, middle) < radius ? 1 : 0; });
    RegionMap traced = trace(picture);
    expectLaws(picture, traced, "radius " + std::to_string(radius));
    ASSERT_EQ(regionOf(traced, 1).outlines.size(), 1u);
    const Outline& outline = regionOf(traced, 1).outlines.front();
    EXPECT_LE(outline.curves.size(), 22u) << radius;
    walkAlong(outline, 0.25, [&](glm::dvec2 p) { EXPECT_NEAR(glm::distance(p, middle), radius, 0.45); });
  }
}

TEST(TraceRegions, BoxesKeepTheirCorners) {
  for (int edge : {4, 6, 12, 40}) {
    Picture picture =
        paint({60, 60}, [&](glm::dvec2 p) { return p.x > 7 && p.x < 7 + edge && p.y > 9 && p.y < 9 + edge ? 5 : 0; });
    RegionMap traced = trace(picture);
    const Outline& outline = regionOf(traced, 5).outlines.front();
    ASSERT_EQ(outline.curves.size(), 4u) << edge;
    glm::dvec2 from = outline.start;
    for (const Curve& curve : outline.curves) {
      EXPECT_TRUE(isStraight(from, curve)) << edge;
      EXPECT_NEAR(glm::distance(from, curve.end), edge, 1e-6);
      from = curve.end;
    }
    EXPECT_EQ(expectLaws(picture, traced, "box").wrong, 0);
  }
}

TEST(TraceRegions, TurnedBoxesHaveFourStraightSides) {
  for (double angle : {0.05, 0.2, 0.5, 0.785}) {
    Picture picture = paint({200, 200}, [&](glm::dvec2 p) {
      p -= glm::dvec2(100.2, 99.7);
      glm::dvec2 q(p.x * std::cos(angle) + p.y * std::sin(angle), p.y * std::cos(angle) - p.x * std::sin(angle));
      return std::abs(q.x) < 60 && std::abs(q.y) < 35 ? 1 : 0;
    });
    RegionMap traced = trace(picture);
    expectLaws(picture, traced, "turned");
    EXPECT_LE(regionOf(traced, 1).outlines.front().curves.size(), 10u) << angle;
  }
}

TEST(TraceRegions, ThinLinesStayWhole) {
  for (double width : {1.0, 1.5, 3.0}) {
    Picture picture = paint({200, 120}, [&](glm::dvec2 p) {
      double slope = 40.0 / 25.0 * std::cos(p.x / 25.0);
      bool isIn = std::abs(p.y - 60.0 - 40.0 * std::sin(p.x / 25.0)) < 0.5 * width * std::sqrt(1.0 + slope * slope);
      return isIn && p.x > 10 && p.x < 190 ? 1 : 0;
    });
    RegionMap traced = trace(picture);
    expectLaws(picture, traced, "thin");
    EXPECT_EQ(regionOf(traced, 1).outlines.size(), 1u) << width;
  }
}

TEST(TraceRegions, ThreeMeetInAPoint) {
  glm::dvec2 middle(99.4, 100.3);
  Picture picture = paint({200, 200}, [&](glm::dvec2 p) {
    p -= middle;
    if (glm::length(p) > 80) return 0;
    double angle = std::atan2(p.y, p.x);
    return angle < -1.0 ? 1 : angle < 1.2 ? 2 : 3;
  });
  RegionMap traced = trace(picture);
  expectLaws(picture, traced, "three");
  // Six borders and the edge of the picture; each border between two is once there.
  EXPECT_EQ(traced.borders.size(), 7u);
  int ends = 0;
  for (const Border& border : traced.borders) {
    if (border.left == 0 || border.right == 0 || border.line.isClosed) continue;
    for (glm::dvec2 end : {border.line.start, border.line.curves.back().end})
      if (glm::distance(end, middle) < 1.2) ++ends;
    EXPECT_LE(border.line.curves.size(), 6u);  // they are straight
  }
  EXPECT_EQ(ends, 3);
}

TEST(TraceRegions, HolesAreOutlinesOfWhatIsAround) {
  Picture picture = paint({120, 120}, [](glm::dvec2 p) {
    double radius = glm::distance(p, {60, 60});
    return radius < 20 ? 0 : radius < 50 ? 7 : 0;
  });
  RegionMap traced = trace(picture);
  expectLaws(picture, traced, "ring");
  ASSERT_EQ(traced.regions.size(), 1u);
  EXPECT_EQ(traced.regions.front().outlines.size(), 2u);
  EXPECT_NEAR(traced.regions.front().area, 3.14159265 * (2500 - 400), 30.0);
}

TEST(TraceRegions, TheEdgeOfThePictureIsStraight) {
  Picture picture = paint({80, 60}, [](glm::dvec2 p) { return p.x + 0.3 * p.y < 50 ? 2 : 3; });
  RegionMap traced = trace(picture);
  EXPECT_LE(expectLaws(picture, traced, "halves").wrong, 6);
  for (const Border& border : traced.borders) {
    if (border.left != kOutside && border.right != kOutside) continue;
    walkAlong(border.line, 0.5,
              [](glm::dvec2 p) { EXPECT_NEAR(std::min(std::min(p.x, 80 - p.x), std::min(p.y, 60 - p.y)), 0.0, 1e-9); });
  }
  // A picture that one region fills.
  RegionMap whole = trace(paint({5, 4}, [](glm::dvec2) { return 1; }));
  ASSERT_EQ(whole.regions.size(), 1u);
  EXPECT_EQ(whole.regions.front().outlines.front().curves.size(), 4u);
  EXPECT_TRUE(trace(paint({5, 4}, [](glm::dvec2) { return -1; })).regions.empty());
}

TEST(TraceRegions, SpecksBecomePartOfWhatIsAround) {
  Picture picture = paint({100, 100}, [](glm::dvec2 p) {
    if (glm::distance(p, {30, 30}) < 2) return 4;
    if (glm::distance(p, {70, 70}) < 5) return 6;
    return glm::distance(p, {50, 50}) < 45 ? 1 : 0;
  });
  RegionMap traced = trace(picture, 30.0);
  ASSERT_EQ(traced.regions.size(), 2u);
  EXPECT_EQ(traced.regions[0].id, 1);
  EXPECT_EQ(traced.regions[0].outlines.size(), 2u);
  EXPECT_EQ(traced.regions[1].id, 6);
  EXPECT_EQ(trace(picture, 0.0).regions.size(), 3u);
}

TEST(TraceRegions, CoverageMovesAnOutlineByPartsOfAPixel) {
  glm::dvec2 middle(60.27, 59.61);
  double radius = 41.3;
  Picture picture = paint({120, 120}, [&](glm::dvec2 p) { return glm::distance(p, middle) < radius ? 1 : 0; });
  std::vector<float> coverage;
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 120; ++x) {
      int inside = 0;
      for (int i = 0; i < 64; ++i)
        inside += glm::distance(glm::dvec2(x + (i % 8 + 0.5) / 8, y + (i / 8 + 0.5) / 8), middle) < radius;
      coverage.push_back(float(inside) / 64.0f);
    }
  Progress progress;
  RegionMap traced = traceRegions({picture.size, picture.ids, coverage}, {}, progress);
  walkAlong(regionOf(traced, 1).outlines.front(), 0.25,
            [&](glm::dvec2 p) { EXPECT_NEAR(glm::distance(p, middle), radius, 0.3); });
}

TEST(TraceRegions, NoiseIsTracedWithoutHarm) {
  std::mt19937 random(2);
  for (double least : {0.0, 12.0}) {
    Picture picture = paint({150, 130}, [&](glm::dvec2) { return int(random() % 4u); });
    RegionMap traced = trace(picture, least);
    if (least == 0.0) {
      EXPECT_EQ(faultsOf(picture, traced).wrongInside, 0);
      EXPECT_LT(faultsOf(picture, traced).worst, kWorst);
    }
    for (const Region& region : traced.regions)
      for (const Outline& outline : region.outlines)
        walkAlong(outline, 0.5, [](glm::dvec2 p) { EXPECT_TRUE(p.x > -1 && p.x < 151 && p.y > -1 && p.y < 131); });
  }
}

TEST(TraceRegions, ManyRegionsOfALargePictureAreAMap) {
  std::mt19937 random(1);
  std::vector<glm::dvec2> seeds;
  for (int i = 0; i < 60; ++i) seeds.emplace_back(double(random() % 1200u), double(random() % 900u));
  Picture picture = paint({1200, 900}, [&](glm::dvec2 p) {
    p += glm::dvec2(12.0 * std::sin(p.y / 50.0) + 3.0 * std::sin(p.y / 13.0), 12.0 * std::sin(p.x / 60.0));
    double best = 120.0;
    int id = 0;
    for (std::size_t i = 0; i < seeds.size(); ++i)
      if (double distance = glm::distance(p, seeds[i]); distance < best) {
        best = distance;
        id = int(i) + 1;
      }
    return id;
  });
  Faults faults = expectLaws(picture, trace(picture, 12.0), "map");
  EXPECT_LT(faults.per1000, 40.0);
}

TEST(TraceRegions, SlopesAreStraightHoweverLongTheirSteps) {
  for (double slope : {0.004, 0.01, 0.03, 0.1, 0.33, 0.5, 0.77}) {
    Picture picture = paint({900, 750}, [&](glm::dvec2 p) { return p.y > slope * p.x + 20.3 ? 1 : 0; });
    RegionMap traced = trace(picture);
    expectLaws(picture, traced, "slope " + std::to_string(slope));
    for (const Border& border : traced.borders) {
      if (border.left == kOutside || border.right == kOutside) continue;
      EXPECT_LE(border.line.curves.size(), 11u) << slope;
      walkAlong(border.line, 1.0, [&](glm::dvec2 p) { EXPECT_NEAR(p.y, slope * p.x + 20.3, 0.5) << slope; });
    }
  }
}

TEST(TraceRegions, NothingIsFarFromPixelsThatAreRough) {
  std::mt19937 random(5);
  Picture smooth = paint({300, 300}, [&](glm::dvec2 p) {
    double angle = std::atan2(p.y - 150, p.x - 150), radius = glm::distance(p, {150, 150});
    return radius + 5 * std::sin(17 * angle) + 2 * std::sin(53 * angle) < 90 ? 1 : radius < 130 ? 2 : 0;
  });
  Picture rough = paint(smooth.size, [&](glm::dvec2 p) {
    return smooth.at(glm::ivec2(p) + glm::ivec2(int(random() % 5u) - 2, int(random() % 5u) - 2));
  });
  for (int& id : rough.ids) id = std::max(id, 0);
  EXPECT_LT(faultsOf(rough, trace(rough)).worst, kWorst);
  std::vector<glm::dvec2> seeds;
  for (int i = 0; i < 1500; ++i) seeds.emplace_back(double(random() % 200u), double(random() % 200u));
  Picture crowd = paint({200, 200}, [&](glm::dvec2 p) {
    auto nearest = std::ranges::min_element(seeds, {}, [&](glm::dvec2 seed) { return glm::distance(p, seed); });
    return int(nearest - seeds.begin()) % 40 + 1;
  });
  EXPECT_LT(faultsOf(crowd, trace(crowd)).worst, kWorst);
}

TEST(TraceRegions, IsCancelled) {
  Progress progress;
  progress.cancel();
  Picture picture = paint({10, 10}, [](glm::dvec2) { return 1; });
  EXPECT_THROW(traceRegions(picture.map(), {}, progress), Cancelled);
}

}  // namespace
}  // namespace velum::vector
