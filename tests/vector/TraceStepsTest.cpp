#include "vector/TraceSteps.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "SeenSurface.h"
#include "TracedPictures.h"

namespace velum::vector {
namespace {

std::vector<Stroke> strokesOf(const Seen& seen, const StepOptions& options) {
  Progress progress;
  return traceSteps(seen.map(), seen.view(), options, progress);
}

/// The largest distance of strokes from a line, and how much of it they cover.
struct Fit {
  double worst = 0.0, length = 0.0;
};
Fit fitOf(const std::vector<Stroke>& strokes, const std::function<double(glm::dvec2)>& distanceAt) {
  Fit fit;
  for (const Stroke& stroke : strokes) {
    glm::dvec2 last = stroke.line.start;
    walkAlong(stroke.line, 0.5, [&](glm::dvec2 p) {
      fit.worst = std::max(fit.worst, std::abs(distanceAt(p)));
      fit.length += glm::distance(last, p);
      last = p;
    });
  }
  return fit;
}

StepOptions pen(double width, double steps, double creases) {
  StepOptions options;
  options.width = width;
  options.steps = steps;
  options.creases = creases;
  options.stepLength = 2.5;
  return options;
}

TEST(TraceSteps, AStepIsALineWhereItIs) {
  glm::dvec2 middle(100.2, 99.8);
  for (double width : {2.4, 6.0, 10.0}) {
    Seen seen = look({200, 200}, [&](glm::dvec2 p) { return glm::distance(p, middle) < 60 ? 60.0 : 0.0; });
    Fit fit = fitOf(strokesOf(seen, pen(width, 1.0, 0.0)), [&](glm::dvec2 p) { return glm::distance(p, middle) - 60; });
    EXPECT_LT(fit.worst, 1.0) << width;
    EXPECT_NEAR(fit.length, 2.0 * 3.14159265 * 60.0, 12.0) << width;
  }
}

TEST(TraceSteps, ACreaseIsALineWhereItIs) {
  Seen seen = look({200, 160}, [](glm::dvec2 p) { return -1.2 * std::abs(0.8 * (p.x - 100) + 0.6 * (p.y - 80)); });
  std::vector<Stroke> strokes = strokesOf(seen, pen(3.0, 0.0, 1.0));
  Fit fit = fitOf(strokes, [](glm::dvec2 p) { return 0.8 * (p.x - 100) + 0.6 * (p.y - 80); });
  EXPECT_LT(fit.worst, 0.75);
  EXPECT_GT(fit.length, 185.0);  // from edge to edge, less the bands' ends
  std::size_t curves = 0;
  for (const Stroke& stroke : strokes) curves += stroke.line.curves.size();
  EXPECT_LE(curves, 5u);
}

TEST(TraceSteps, PlanesAndBallsHaveNone) {
  EXPECT_TRUE(strokesOf(look({150, 150}, [](glm::dvec2 p) { return 0.9 * p.x - 0.7 * p.y; }), pen(3, 1, 1)).empty());
  Seen ball = look({200, 200}, [](glm::dvec2 p) {
    double off = glm::distance(p, {100, 100});
    return off < 90 ? std::sqrt(90.0 * 90.0 - off * off) : std::numeric_limits<double>::quiet_NaN();
  });
  Fit fit = fitOf(strokesOf(ball, pen(3, 1, 1)), [](glm::dvec2 p) { return glm::distance(p, {100, 100}); });
  EXPECT_TRUE(fit.length == 0.0 || fit.worst > 80.0);
}

TEST(TraceSteps, SoftLinesAreWeakerStrokes) {
  auto roof = [](double slope) {
    return look({120, 120}, [slope](glm::dvec2 p) { return -slope * std::abs(p.x - 60.0); });
  };
  auto strongest = [&](double slope) {
    double most = 0.0;
    for (const Stroke& stroke : strokesOf(roof(slope), pen(3.0, 0.0, 1.0))) most = std::max(most, stroke.strength);
    return most;
  };
  EXPECT_EQ(strongest(0.1), 0.0);
  EXPECT_LT(strongest(0.35), strongest(1.5));
  EXPECT_EQ(strongest(1.5), 1.0);
}

TEST(TraceSteps, PerspectiveChangesNothingForPlanes) {
  // A plane seen at an angle through a lens of 60 degrees.
  Seen seen{{160, 120}, {}, {}, {}};
  View view{false, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, std::tan(3.14159265 / 6.0)};
  glm::dvec3 normal = glm::normalize(glm::dvec3(0.5, 0.3, -1.0));
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 160; ++x) {
      glm::dvec2 off = (glm::dvec2(x + 0.5, y + 0.5) - glm::dvec2(80, 60)) * (2.0 * view.halfHeight / 120.0);
      glm::dvec3 ray = glm::normalize(glm::dvec3(off.x, -off.y, 1.0));
      seen.ids.push_back(1);
      seen.distances.push_back(float(glm::dot(normal, glm::dvec3(0, 0, 300)) / glm::dot(normal, ray)));
      seen.normals.push_back(glm::vec3(normal));
    }
  StepOptions options = pen(3, 1, 0);
  for (float strength : edgeStrengths(seen.map(), view, options)) EXPECT_LT(strength, 0.01f);
}

}  // namespace
}  // namespace velum::vector
