// Volumes, surfaces and faces of what cuts leave, against closed forms. Tolerances: docs/PERFORMANCE.md, Measures.
#include "session/measure/Left.h"

#include <gtest/gtest.h>

#include "MeasureGrids.h"
#include "session/measure/Region.h"
#include "session/measure/SurfaceLeft.h"
#include "sheetShapes.h"

namespace velum::session {
namespace {

constexpr double kBallRadius = 14.0, kBallVolume = 4.0 / 3.0 * M_PI * kBallRadius * kBallRadius * kBallRadius;
constexpr double kBallSurface = 4.0 * M_PI * kBallRadius * kBallRadius;

double capVolume(double height) { return M_PI * height * height * (kBallRadius - height / 3.0); }

StructureLeft leftOf(const scene::Scene& scene) {
  Progress progress;
  return measureLeft(scene, 1, progress)[1];
}

double surfaceOf(const scene::Scene& scene) {
  Progress progress;
  StructureLeft left = leftOf(scene);
  return surfaceLeft(scene, 1, left.low, left.high, progress);
}

TEST(MeasureLeft, BallsAndEllipsoidsHaveTheirVolumeAndSurface) {
  // Surfaces of ellipsoids by Knud Thomsen's formula, which is within 0.1 % for these.
  glm::dvec3 half(16, 11, 9);
  auto power = [](double a, double b) { return std::pow(a * b, 1.6075); };
  double thomsen =
      4.0 * M_PI *
      std::pow((power(half.x, half.y) + power(half.y, half.z) + power(half.z, half.x)) / 3.0, 1.0 / 1.6075);
  for (const MeasureGrid& grid : measureGrids()) {
    SCOPED_TRACE(grid.name);
    scene::Scene ball = sceneOfBall(grid, kBallRadius);
    StructureLeft left = leftOf(ball);
    EXPECT_NEAR(left.whole, kBallVolume, 0.005 * kBallVolume);
    EXPECT_EQ(left.left, left.whole);
    EXPECT_TRUE(left.faces.empty());
    EXPECT_NEAR(surfaceOf(ball), kBallSurface, 0.01 * kBallSurface);
    scene::Scene ellipsoid = sceneOfBody(grid, [&](glm::dvec3 p) { return glm::length(p / half) < 1.0; });
    double volume = 4.0 / 3.0 * M_PI * half.x * half.y * half.z;
    EXPECT_NEAR(leftOf(ellipsoid).whole, volume, 0.006 * volume);
    EXPECT_NEAR(surfaceOf(ellipsoid), thomsen, 0.01 * thomsen);
  }
}

TEST(MeasureLeft, BoxesOfVoxelsHaveTheirVolumeAndSurface) {
  for (const MeasureGrid& grid : measureGrids()) {
    SCOPED_TRACE(grid.name);
    glm::ivec3 dims = dimsOf(grid), low = dims / 4, high = dims * 3 / 4;
    glm::dmat4 frame = frameOf(grid);
    scene::Scene scene;
    scene.labels.data = Shared<LabelVolume>(makeLabels(
        dims,
        [&](glm::ivec3 v) {
          return glm::all(glm::greaterThanEqual(v, low)) && glm::all(glm::lessThan(v, high)) ? 1 : 0;
        },
        frame));
    glm::dvec3 edges(high - low);
    double volume = std::abs(glm::determinant(glm::dmat3(frame))) * edges.x * edges.y * edges.z;
    EXPECT_NEAR(leftOf(scene).whole, volume, 0.01 * volume);
    glm::dmat3 axes(frame);
    glm::dvec3 a = axes[0] * edges.x, b = axes[1] * edges.y, c = axes[2] * edges.z;
    double surface =
        2.0 * (glm::length(glm::cross(a, b)) + glm::length(glm::cross(b, c)) + glm::length(glm::cross(c, a)));
    EXPECT_NEAR(surfaceOf(scene), surface, 0.008 * surface);
  }
}

/// Half lengths along turned axes.
const glm::dmat3 kTurned(glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(0.6, 0.64, 0.48)));

/// 20 to 40 voxels thick, by their longest edge.
TEST(MeasureLeft, EdgesOfTurnedBoxesCylindersAndConesCount) {
  std::vector<MeasureGrid> grids = measureGrids();
  grids.push_back({"long", {0.3, 0.3, 1.2}, 0.5, 0.0});
  for (const MeasureGrid& grid : grids) {
    SCOPED_TRACE(grid.name);
    auto expectSurface = [&](const char* name, auto isIn, double wanted) {
      scene::Scene scene = sceneOfBody(grid, [&](glm::dvec3 p) { return isIn(p * kTurned); });
      EXPECT_NEAR(surfaceOf(scene), wanted, (grid.name == "long" ? 0.02 : 0.015) * wanted) << name;
    };
    glm::dvec3 half(14, 12, 11);
    expectSurface(
        "box", [&](glm::dvec3 p) { return glm::all(glm::lessThan(glm::abs(p), half)); },
        8.0 * (half.x * half.y + half.y * half.z + half.z * half.x));
    expectSurface(
        "cylinder", [](glm::dvec3 p) { return std::hypot(p.x, p.y) < 12.0 && std::abs(p.z) < 13.0; },
        2.0 * M_PI * 12.0 * (12.0 + 26.0));
    expectSurface(
        "cone", [](glm::dvec3 p) { return p.z > -10.0 && std::hypot(p.x, p.y) < 14.0 * (18.0 - p.z) / 28.0; },
        M_PI * 14.0 * (14.0 + std::hypot(14.0, 28.0)));
    expectSurface(
        "ring", [](glm::dvec3 p) { return std::hypot(std::hypot(p.x, p.y) - 12.0, p.z) < 7.0; },
        4.0 * M_PI * M_PI * 12.0 * 7.0);
  }
}

TEST(MeasureLeft, ThinThingsHaveTheirSurfaceAndTheFacesAcrossThem) {
  for (const MeasureGrid& grid : measureGrids()) {
    SCOPED_TRACE(grid.name);
    // A slab of about three voxels: no part of it is beyond what its sides' means reach.
    double thick = 3.0 * std::max({std::abs(grid.spacing.x), grid.spacing.y, std::abs(grid.spacing.z)});
    glm::dvec3 half(14, 13, 0.5 * thick);
    scene::Scene scene =
        sceneOfBody(grid, [&](glm::dvec3 p) { return glm::all(glm::lessThan(glm::abs(p * kTurned), half)); });
    double surface = 8.0 * (half.x * half.y + half.y * half.z + half.z * half.x);
    EXPECT_NEAR(surfaceOf(scene), surface, 0.06 * surface);
    int id = scene::addCut(scene, cutAt(scene::CutShape::Plane, {0, 0, 0}, kTurned[0]));
    double face = 2.0 * half.y * thick;
    EXPECT_NEAR(leftOf(scene).faces[id], face, 0.05 * face);
  }
}

/// What is thin is shown thicker than its voxels: that must not count where the rest is thick.
TEST(MeasureLeft, WhatIsLeftIsOfVoxelsInThinPartsToo) {
  for (const MeasureGrid& grid : measureGrids()) {
    SCOPED_TRACE(grid.name);
    scene::Scene scene = sceneOfBody(grid, [](glm::dvec3 p) {
      return glm::length(p - glm::dvec3(-8, 0, 0)) < 9.0 || (p.x > -8 && p.x < 17 && std::abs(p.z) < 0.9);
    });
    scene::addCut(scene, cutAt(scene::CutShape::Plane, {2, 0, 0}, {-1, 0, 0}));
    double voxels = 0.0;
    const LabelVolume& labels = *scene.labels.data;
    glm::ivec3 v;
    for (v.z = 0; v.z < labels.dims().z; ++v.z)
      for (v.y = 0; v.y < labels.dims().y; ++v.y)
        for (v.x = 0; v.x < labels.dims().x; ++v.x)
          voxels += labels.at(v) == 1 && (labels.worldFromVoxel() * glm::dvec4(v, 1.0)).x > kMeasureMiddle.x + 2.0;
    double wanted = voxels * std::abs(glm::determinant(glm::dmat3(labels.worldFromVoxel())));
    EXPECT_NEAR(leftOf(scene).left, wanted, 0.04 * wanted);  // half a layer of voxels, of 15 mm
  }
}

TEST(MeasureLeft, APlaneLeavesACapWithAFace) {
  for (const MeasureGrid& grid : measureGrids())
    for (glm::dvec3 axis : {glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0), glm::dvec3(1, -2, 0.7)})
      for (double off : {0.0, 5.3}) {
        if ((axis.x > 0.5) == (off > 0.0)) continue;
        SCOPED_TRACE(grid.name);
        scene::Scene scene = sceneOfBall(grid, kBallRadius);
        glm::dvec3 normal = glm::normalize(axis);
        int id = scene::addCut(scene, cutAt(scene::CutShape::Plane, off * normal, axis));
        StructureLeft left = leftOf(scene);
        double wanted = kBallVolume - capVolume(kBallRadius - off);
        double face = M_PI * (kBallRadius * kBallRadius - off * off);
        EXPECT_NEAR(left.left, wanted, 0.008 * wanted);
        EXPECT_NEAR(left.faces[id], face, 0.01 * face);
        Progress progress;
        double surface = 2.0 * M_PI * kBallRadius * (kBallRadius + off);
        EXPECT_NEAR(surfaceOf(scene), surface, 0.012 * surface);
        // All of it together, as a region tells it.
        Measured region = measureStructure(scene, 1, left, progress);
        EXPECT_NEAR(findQuantity(region, "surface")->value, surface + face, 0.012 * (surface + face));
        EXPECT_NEAR(findQuantity(region, "share")->value, 100.0 * wanted / kBallVolume, 0.5);
      }
}

TEST(MeasureLeft, FacesOfSpheresBoxesCylindersAndWedges) {
  for (const MeasureGrid& grid : measureGrids()) {
    SCOPED_TRACE(grid.name);
    scene::Scene scene = sceneOfBall(grid, kBallRadius);
    auto withCut = [&](const scene::Cut& cut) {
      scene.cuts.clear();
      int id = scene::addCut(scene, cut);
      StructureLeft left = leftOf(scene);
      return std::pair(left.left, left.faces[id]);
    };
    auto [sphereLeft, sphereFace] = withCut(cutAt(scene::CutShape::Sphere, {1, 2, -1}, {0, 0, 1}, glm::dvec3(14.0)));
    double hole = 4.0 / 3.0 * M_PI * 343.0;
    EXPECT_NEAR(sphereLeft, kBallVolume - hole, 0.008 * kBallVolume);
    EXPECT_NEAR(sphereFace, 4.0 * M_PI * 49.0, 0.01 * 4.0 * M_PI * 49.0);
    auto [boxLeft, boxFace] = withCut(cutAt(scene::CutShape::Box, {0, 0, 0}, {0.3, 0.2, 1}, {11, 12, 13}));
    EXPECT_NEAR(boxLeft, kBallVolume - 11 * 12 * 13, 0.008 * kBallVolume);
    double boxSurface = 2.0 * (11 * 12 + 12 * 13 + 13 * 11);
    EXPECT_NEAR(boxFace, boxSurface, 0.015 * boxSurface);
    auto [tubeLeft, tubeFace] = withCut(cutAt(scene::CutShape::Cylinder, {0, 0, 0}, {1, 1, 1}, {8, 8, 200}));
    double half = std::sqrt(kBallRadius * kBallRadius - 16.0);  // of what is left: a ring as high as this
    EXPECT_NEAR(tubeLeft, 4.0 / 3.0 * M_PI * half * half * half, 0.01 * kBallVolume);
    EXPECT_NEAR(tubeFace, 2.0 * M_PI * 4.0 * 2.0 * half, 0.01 * 2.0 * M_PI * 4.0 * 2.0 * half);
    // Two planes that open a quarter.
    scene.cuts.clear();
    int first = scene::addCut(scene, cutAt(scene::CutShape::Plane, {0, 0, 0}, {1, 0, 0}));
    scene::Cut joined = cutAt(scene::CutShape::Plane, {0, 0, 0}, {0, 1, 0});
    joined.joined = true;
    int second = scene::addCut(scene, joined);
    StructureLeft wedge = leftOf(scene);
    double disc = M_PI * kBallRadius * kBallRadius;
    EXPECT_NEAR(wedge.left, 0.75 * kBallVolume, 0.008 * kBallVolume);
    EXPECT_NEAR(wedge.faces[first], 0.5 * disc, 0.012 * 0.5 * disc);
    EXPECT_NEAR(wedge.faces[second], 0.5 * disc, 0.012 * 0.5 * disc);
  }
}

TEST(MeasureLeft, WhatACutSparesStaysToItsDepth) {
  for (const MeasureGrid& grid : measureGrids()) {
    SCOPED_TRACE(grid.name);
    scene::Scene scene = sceneOfBall(grid, kBallRadius);
    scene::Cut cut = cutAt(scene::CutShape::Plane, {0, 0, 0}, {0, 0, 1});
    scene::Spare spare;
    spare.structure = 1;
    cut.spares = {spare};
    int id = scene::addCut(scene, cut);
    EXPECT_EQ(leftOf(scene).left, leftOf(scene).whole);
    scene.cuts[0].spares[0].distance = 6.0;
    StructureLeft left = leftOf(scene);
    EXPECT_NEAR(left.left, kBallVolume - capVolume(kBallRadius - 6.0), 0.008 * kBallVolume);
    double face = M_PI * (kBallRadius * kBallRadius - 36.0);
    EXPECT_NEAR(left.faces[id], face, 0.01 * face);
  }
}

TEST(MeasureLeft, ASheetLeavesWhatLiesBelowIt) {
  constexpr double kHeight = 6.0;
  for (const MeasureGrid& grid : measureGrids()) {
    SCOPED_TRACE(grid.name);
    scene::Scene scene = sceneOfBall(grid, kBallRadius);
    scene::Cut cut = cutAt(scene::CutShape::Membrane, {0, 0, 0}, {0, 0, 1}, {80, 80, 40});
    // A table: flat in the middle, where the ball is.
    cut.membrane->shape = makeSheet({33, 33}, cut.size, [&](glm::vec2 s) {
      float fall = std::clamp((1.0f - std::max(std::abs(s.x), std::abs(s.y))) * 2.5f, 0.0f, 1.0f);
      return glm::vec3(40.0f * s.x, 40.0f * s.y, float(kHeight) * fall);
    });
    cut.membrane->cloth.particles = {33, 33};
    int id = scene::addCut(scene, cut);
    StructureLeft left = leftOf(scene);
    double wanted = kBallVolume - capVolume(kBallRadius - kHeight);
    double face = M_PI * (kBallRadius * kBallRadius - kHeight * kHeight);
    EXPECT_NEAR(left.left, wanted, 0.01 * wanted);
    EXPECT_NEAR(left.faces[id], face, 0.01 * face);
  }
}

TEST(MeasureLeft, FacesOfSeveralStructuresAddUp) {
  MeasureGrid grid = measureGrids()[1];
  glm::dmat4 frame = frameOf(grid);
  scene::Scene scene;
  scene.labels.data = Shared<LabelVolume>(makeLabels(
      dimsOf(grid),
      [&](glm::ivec3 v) {
        glm::dvec3 p = glm::dvec3(frame * glm::dvec4(v, 1.0)) - kMeasureMiddle;
        return glm::length(p) >= kBallRadius ? 0 : p.x < 2.0 ? 3 : 7;
      },
      frame));
  int id = scene::addCut(scene, cutAt(scene::CutShape::Plane, {0, 0, 0}, {0, 0, 1}));
  Progress progress;
  std::vector<FaceArea> faces = faceAreas(scene, id, progress);
  ASSERT_EQ(faces.size(), 2u);
  EXPECT_EQ(faces[0].structure, 3);
  EXPECT_EQ(faces[1].structure, 7);
  double disc = M_PI * kBallRadius * kBallRadius, angle = std::acos(2.0 / kBallRadius);
  double segment = kBallRadius * kBallRadius * (angle - std::sin(angle) * std::cos(angle));
  EXPECT_NEAR(faces[0].area + faces[1].area, disc, 0.01 * disc);
  EXPECT_NEAR(faces[1].area, segment, 0.015 * segment);
  EXPECT_TRUE(faceAreas(scene, id + 1, progress).empty());
}

}  // namespace
}  // namespace velum::session
