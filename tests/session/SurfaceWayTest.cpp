// Ways over surfaces against great circles, helices and unfolded boxes. Tolerances: docs/PERFORMANCE.md, Measures.
#include "session/measure/SurfaceWay.h"

#include <gtest/gtest.h>

#include <random>

#include "MeasureGrids.h"
#include "session/measure/Measure.h"

namespace velum::session {
namespace {

constexpr double kWayRadius = 15.0;

SurfaceWay wayOf(const scene::Scene& scene, glm::dvec3 a, glm::dvec3 b) {
  Progress progress;
  return wayOverSurface(scene, kMeasureMiddle + a, kMeasureMiddle + b, progress);
}

/// A volume whose values fall from the middle outwards, and are 500 at a radius.
template <class RadiusOf>
scene::Scene sceneOfValues(const MeasureGrid& grid, RadiusOf radiusOf) {
  glm::dmat4 frame = frameOf(grid);
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(makeVolume(
      dimsOf(grid), SampleType::Int16,
      [&](glm::ivec3 v) {
        return 500.0 - 100.0 * (radiusOf(glm::dvec3(frame * glm::dvec4(v, 1.0)) - kMeasureMiddle) - kWayRadius);
      },
      frame));
  return scene;
}
double aboutAxis(glm::dvec3 p) { return std::hypot(p.x, p.y); }
double aboutPoint(glm::dvec3 p) { return glm::length(p); }

TEST(SurfaceWay, OverABallIsAGreatCircle) {
  std::mt19937 random(4);
  std::normal_distribution<double> any;
  for (const MeasureGrid& grid : measureGrids())
    for (bool isLabelled : {false, true}) {
      SCOPED_TRACE(grid.name + (isLabelled ? ", labels" : ", values"));
      scene::Scene scene = isLabelled ? sceneOfBall(grid, kWayRadius) : sceneOfValues(grid, aboutPoint);
      for (int i = 0; i < 3; ++i) {
        glm::dvec3 a = glm::normalize(glm::dvec3(any(random), any(random), any(random)));
        glm::dvec3 b = glm::normalize(glm::dvec3(any(random), any(random), any(random)));
        double wanted = kWayRadius * std::acos(glm::dot(a, b));
        if (wanted < 5.0) continue;
        SurfaceWay found = wayOf(scene, kWayRadius * a, kWayRadius * b);
        ASSERT_EQ(found.problem, "");
        EXPECT_NEAR(found.way.length, wanted, (isLabelled ? 0.015 : 0.002) * wanted);
        for (const glm::dvec3& p : found.way.points)
          EXPECT_NEAR(glm::distance(p, kMeasureMiddle), kWayRadius, isLabelled ? 1.0 : 0.1);
      }
    }
}

TEST(SurfaceWay, OverACylinderIsAHelix) {
  for (const MeasureGrid& grid : measureGrids())
    for (bool isLabelled : {false, true}) {
      SCOPED_TRACE(grid.name + (isLabelled ? ", labels" : ", values"));
      scene::Scene scene = isLabelled ? sceneOfBody(grid, [](glm::dvec3 p) { return aboutAxis(p) < kWayRadius; })
                                      : sceneOfValues(grid, aboutAxis);
      for (double angle : {0.6, 1.7, 2.8}) {
        glm::dvec3 a(kWayRadius, 0, -5), b(kWayRadius * std::cos(angle), kWayRadius * std::sin(angle), 6);
        double wanted = std::hypot(kWayRadius * angle, 11.0);
        SurfaceWay found = wayOf(scene, a, b);
        ASSERT_EQ(found.problem, "");
        EXPECT_NEAR(found.way.length, wanted, (isLabelled ? 0.01 : 0.002) * wanted);
      }
    }
}

TEST(SurfaceWay, WhatCutsHaveRemovedIsNoWay) {
  MeasureGrid grid = measureGrids()[0];
  scene::Scene scene = sceneOfValues(grid, aboutPoint);
  glm::dvec3 a = kWayRadius * glm::normalize(glm::dvec3(-1, 0, 1)),
             b = kWayRadius * glm::normalize(glm::dvec3(1, 0, 1));
  double over = wayOf(scene, a, b).way.length;
  EXPECT_NEAR(over, kWayRadius * M_PI / 2.0, 0.002 * over);
  // The cap above both points goes: the way leads over the face, which is straight.
  scene::addCut(scene, cutAt(scene::CutShape::Plane, {0, 0, a.z - 0.3}, {0, 0, 1}));
  SurfaceWay face = wayOf(scene, a, b);
  ASSERT_EQ(face.problem, "");
  EXPECT_NEAR(face.way.length, glm::distance(a, b), 0.02 * over);
  EXPECT_LT(face.way.length, 0.95 * over);
  // A trench between them: the way leads down into it and up again, or round it.
  scene.cuts.clear();
  scene::addCut(scene, cutAt(scene::CutShape::Box, {0, 0, kWayRadius}, {0, 0, 1}, {4, 200, 12}));
  SurfaceWay trench = wayOf(scene, a, b);
  ASSERT_EQ(trench.problem, "");
  EXPECT_GT(trench.way.length, over + 3.0);
  // Two halves hang no longer together.
  scene.cuts[0].size = {4, 200, 200};
  EXPECT_NE(wayOf(scene, a, b).problem, "");
}

TEST(SurfaceWay, OverASurfaceFromAFileIsExact) {
  // A box of 2 x 2 x 2, points of triangles not shared, as STL files have it.
  scene::Scene scene;
  Mesh mesh;
  auto quad = [&](glm::vec3 o, glm::vec3 u, glm::vec3 v) {
    for (glm::vec3 p : {o, o + u, o + u + v, o, o + u + v, o + v}) {
      mesh.indices.push_back(std::uint32_t(mesh.positions.size()));
      mesh.positions.push_back(p);
    }
  };
  for (float side : {-1.0f, 1.0f}) {
    quad({-1, -1, side}, {2, 0, 0}, {0, 2, 0});
    quad({-1, side, -1}, {2, 0, 0}, {0, 0, 2});
    quad({side, -1, -1}, {0, 2, 0}, {0, 0, 2});
  }
  scene.surfaces.emplace_back();
  scene.surfaces[0].data = Shared<Mesh>(std::move(mesh));
  Progress progress;
  // From the middle of one face to that of the next, and to that of the opposite one.
  EXPECT_NEAR(wayOverSurface(scene, {0, 0, 1}, {1, 0, 0}, progress).way.length, 2.0, 1e-9);
  EXPECT_NEAR(wayOverSurface(scene, {0, 0, 1}, {0, 0, -1}, progress).way.length, 4.0, 1e-6);
  // Across an edge, straight once it is unfolded.
  EXPECT_NEAR(wayOverSurface(scene, {0, -0.5, 1}, {1, 0.5, 0.5}, progress).way.length, std::hypot(1.5, 1.0), 1e-9);
  EXPECT_NE(wayOverSurface(scene, {0, 0, 1}, {5, 0, 0}, progress).problem, "");
}

TEST(SurfaceWay, MarksTellIt) {
  scene::Scene scene = sceneOfValues(measureGrids()[1], aboutPoint);
  scene::Mark mark = markOf(scene::MarkKind::Path, {});
  for (glm::dvec3 p : {glm::dvec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}})
    mark.points.push_back(kMeasureMiddle + kWayRadius * p);
  mark.alongSurface = true;
  Progress progress;
  Measured found = measure(scene, mark, progress);
  double wanted = kWayRadius * M_PI;
  EXPECT_NEAR(findQuantity(found, "length")->value, wanted, 0.003 * wanted);
  EXPECT_LT(glm::distance(found.way.front(), mark.points.front()), 0.1);
  EXPECT_LT(glm::distance(found.way.back(), mark.points.back()), 0.1);
  EXPECT_FALSE(isMeasuredAtOnce(mark));
  // In the air there is no surface.
  mark.points[1] = kMeasureMiddle + glm::dvec3(0, 19, 3);
  mark.points[2] = kMeasureMiddle + glm::dvec3(0, 0, 90);
  EXPECT_NE(measure(scene, mark, progress).problem, "");
}

TEST(SurfaceWay, OverAMoleculesModelIsNotKnown) {
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(Model());
  EXPECT_NE(wayOf(scene, {0, 0, 0}, {10, 0, 0}).problem, "");
}

}  // namespace
}  // namespace velum::session
