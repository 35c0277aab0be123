// What is pulled out of cuts: the picture holds [ACS] Prop. 1 and 2 along every ray, and closes what it cuts off.
#include <fmt/format.h>

#include <optional>
#include <random>

#include "NaiveCuts.h"
#include "RenderFixture.h"
#include "scene/Scene.h"
#include "scene/StructureAt.h"

namespace velum {
namespace {

constexpr glm::ivec3 kExtrusionDims(44, 40, 42);
constexpr glm::ivec2 kExtrusionSize(56, 56);
constexpr double kStep = 0.2;      // of the search along a ray, in voxels of 1 mm
constexpr double kTooClose = 0.3;  // to a border of labels, in voxels
constexpr double kThinnest = 0.5;  // what a march of a quarter of a voxel cannot miss
constexpr double kNear = 0.3;      // of the search's step and the march's

/// A solid block of four structures, checkered by eights, before two planes that may open a wedge.
class ExtrusionGL : public RenderTest {
 protected:
  void SetUp() override {
    RenderTest::SetUp();
    mScene = sceneOf(makeVolume(
        kExtrusionDims, SampleType::UInt8, [](glm::ivec3) { return 100; }, centredFrame(kExtrusionDims)));
    makeSolid(mScene);
    mScene.labels.data = Shared<LabelVolume>(makeLabels(
        kExtrusionDims, [](glm::ivec3 p) { return kIds[(p.x / 8 + p.z / 8 * 2) % 4]; },
        mScene.volume.data->worldFromVoxel));
    scene::completeStructures(mScene.labels);
    mScene.rayCast.stepVoxels = 0.25;
    mScene.camera.projection = scene::Projection::Orthographic;
    mScene.camera.height = 70;
    addPlane({0, 6, 0}, {0, -1, 0});
  }
  void addPlane(glm::dvec3 centre, glm::dvec3 axis, bool joined = false) {
    scene::Cut plane;
    plane.centre = centre;
    plane.axis = axis;
    plane.joined = joined;
    scene::addCut(mScene, plane);
  }
  /// Beyond the grid that of its outermost voxel.
  int structureAt(glm::dvec3 world) const {
    glm::dvec3 voxel = glm::clamp(voxelAt(world), glm::dvec3(0.0), glm::dvec3(kExtrusionDims) - 1.0);
    mField = scene::structureFieldOf(mScene);  // held: one is asked for each place
    return scene::structureAt(mScene, glm::dvec3(mScene.volume.data->worldFromVoxel * glm::dvec4(voxel, 1.0))).id;
  }
  glm::dvec3 voxelAt(glm::dvec3 world) const {
    return glm::dvec3(glm::inverse(mScene.volume.data->worldFromVoxel) * glm::dvec4(world, 1.0));
  }
  /// On a border between two labels a place may be of either.
  bool isOnBorder(glm::dvec3 world) const {
    int here = structureAt(world);
    for (int axis = 0; axis < 3; ++axis)
      for (double side : {-kTooClose, kTooClose}) {
        glm::dvec3 beside = world;
        beside[axis] += side;
        if (structureAt(beside) != here) return true;
      }
    return false;
  }

  bool keeps(const TestRay& ray, double t) const { return naive(mScene, ray.at(t), structureAt(ray.at(t))).keeps; }
  /// The first place along a ray that the propositions leave; nothing: they leave none. No place: it cannot be told.
  struct Found {
    std::optional<double> t;
    bool isDoubtful = false;
  };
  Found findFirst(const TestRay& ray, glm::dvec2 box) const {
    for (double t = box.x + 1e-3; t < box.y; t += kStep) {
      Naive at = naive(mScene, ray.at(t), structureAt(ray.at(t)));
      if (at.isDoubtful || isOnBorder(ray.at(t))) return {{}, true};
      if (!at.keeps) continue;
      // The march may pass over what is thinner than two of its steps.
      for (double in = t; in < t + kThinnest; in += 0.5 * kStep)
        if (in > box.y || !keeps(ray, in)) return {{}, true};
      return {t};
    }
    return {};
  }

  /// Along each ray the first place that the propositions leave is what shows, with its structure.
  void expectPropositions(const std::string& what, bool standsOut = true) {
    Image image = draw(mScene, kExtrusionSize, kAllLayers);
    int checked = 0, out = 0;
    for (int y = 0; y < kExtrusionSize.y; ++y)
      for (int x = 0; x < kExtrusionSize.x; ++x) {
        TestRay ray = rayThrough(mScene.camera, kExtrusionSize, {x + 0.5, y + 0.5});
        glm::dvec2 box = boxInterval(*mScene.volume.data, ray);
        Found first = findFirst(ray, box);
        if (first.isDoubtful || (!first.t && box.x >= box.y)) continue;
        ++checked;
        std::string where = fmt::format("{}, pixel {}, {}", what, x, y);
        bool isShown = sampleOf(image, {x, y}, "A") > 0.5f;
        double shown = glm::dot(glm::dvec3(vectorOf(image, {x, y}, "position")) - ray.origin, ray.direction);
        // What the search has passed over, the march may find.
        if (isShown && (!first.t || shown < *first.t - kStep) && keeps(ray, shown)) continue;
        EXPECT_EQ(isShown, first.t.has_value()) << where;
        if (!isShown || !first.t) continue;
        out += !naive(hard(), ray.at(*first.t), 0).keeps;
        EXPECT_NEAR(shown, *first.t, kNear) << where;
        EXPECT_EQ(int(sampleOf(image, {x, y}, "id")), structureAt(ray.at(*first.t + 0.5 * kStep))) << where;
      }
    EXPECT_GT(checked, 250) << what;
    EXPECT_TRUE(out > 30 || !standsOut) << what << ": too little stands out, " << out;
  }
  scene::Scene hard() const {
    scene::Scene scene = mScene;
    for (auto& cut : scene.cuts) cut.spares.clear();
    return scene;
  }

  static constexpr int kIds[] = {1, 2, 300, 65535};
  scene::Scene mScene;
  mutable std::shared_ptr<const StructureField> mField;
};

TEST_F(ExtrusionGL, EveryRayShowsWhatThePropositionsLeave) {
  std::mt19937 random(3);
  auto number = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  for (int round = 0; round < 3; ++round) {
    mScene.cuts.resize(1);
    bool isWedge = round % 3 == 1, isTwo = round % 3 == 2;
    if (isWedge || isTwo) addPlane({-4, 0, 0}, {-1, 0, 0}, isWedge);
    for (auto& cut : mScene.cuts) {
      cut.spares.clear();
      for (int id : kIds)
        if (random() % 4) cut.spares.push_back({id, number(1, 16)});
    }
    lookAlong(mScene, {number(-0.8, -0.2), -1, number(0.1, 0.8)});
    expectPropositions(fmt::format("round {}, {}", round, isWedge ? "wedge" : isTwo ? "two cuts" : "one plane"));
  }
}

TEST_F(ExtrusionGL, AWedgeRemovesWhatBothOfItsPlanesRemove) {
  addPlane({-4, 0, 0}, {-1, 0, 0}, true);
  for (glm::dvec3 along : {glm::dvec3(-0.6, -1, 0.5), {-1, -0.2, 0.1}, {0.5, -1, 0.2}}) {
    lookAlong(mScene, along);
    expectPropositions("a wedge out of which nothing stands", false);
  }
}

TEST_F(ExtrusionGL, OtherCutsTakeFromWhatStandsOut) {
  for (int id : kIds) mScene.cuts[0].spares.push_back({id, 10.0});
  scene::Cut ball;
  ball.shape = scene::CutShape::Sphere;
  ball.centre = {0, 0, 0};
  ball.size = {18, 18, 18};
  scene::addCut(mScene, ball);
  lookAlong(mScene, {-0.4, -1, 0.5});
  expectPropositions("a ball taken out of what stands out");
}

TEST_F(ExtrusionGL, OutOfAMembraneTheDistanceIsFromItsSheet) {
  scene::Cut sheet;
  sheet.shape = scene::CutShape::Membrane;
  sheet.centre = {0, 6, 0};
  sheet.axis = {0, -1, 0};
  sheet.size = {80, 80, 30};
  sheet.membrane.emplace();
  sheet.membrane->cloth.particles = kNaiveParticles;
  sheet.membrane->shape = wavySheet(kNaiveParticles, sheet.size);
  for (int id : {1, 300}) sheet.spares.push_back({id, 5.0});
  mScene.cuts.clear();
  scene::addCut(mScene, sheet);
  lookAlong(mScene, {-0.3, -1, 0.4});
  expectPropositions("a wavy sheet");
}

TEST_F(ExtrusionGL, WhereAnExtrusionEndsThereIsAFaceWithTheNormalOfThePlane) {
  mScene.cuts[0].axis = {0.2, -1, 0.1};
  for (int id : {1, 300}) mScene.cuts[0].spares.push_back({id, 7.0});
  lookAlong(mScene, {-0.3, -1, 0.4});
  glm::dvec3 normal = glm::normalize(mScene.cuts[0].axis);
  for (auto mode : {scene::RenderMode::Volume, scene::RenderMode::Iso}) {
    mScene.rayCast.mode = mode;
    mScene.rayCast.isoValue = 50;
    mScene.lighting.shaded = true;
    mScene.lighting.shadow = mScene.lighting.occlusion = 0;
    Image image = draw(mScene, kExtrusionSize, kAllLayers);
    int faces = 0, slanted = 0;
    eachShown(image, [&](glm::ivec2 pixel, glm::vec3 position) {
      double depth = glm::dot(glm::dvec3(position) - mScene.cuts[0].centre, normal);
      if (std::abs(depth - 7.0) > 0.2) return;
      TestRay ray = rayThrough(mScene.camera, kExtrusionSize, glm::dvec2(pixel) + 0.5);
      // A ray that comes along a wall meets that.
      if (naive(mScene, glm::dvec3(position) - ray.direction * 0.6, structureAt(position)).keeps) return;
      ++faces;
      slanted += glm::dot(glm::dvec3(vectorOf(image, pixel, "normal")), normal) < 0.98;
    });
    EXPECT_GT(faces, 60) << enumName(mode);
    EXPECT_EQ(slanted, 0) << enumName(mode) << " of " << faces;
  }
}

TEST_F(ExtrusionGL, WhatTwoPlanesShareIsMarkedForWhoEditsIt) {
  addPlane({-4, 0, 0}, {-1, 0, 0}, true);
  for (auto& cut : mScene.cuts)
    for (int id : kIds) cut.spares.push_back({id, 9.0});
  lookAlong(mScene, {-0.6, -1, 0.5});
  Progress progress;
  render::Frame frame = frameOf(mScene, kExtrusionSize);
  Image plain = render::renderPicture(renderer(), frame, kAllLayers, 4096, progress);
  frame.marksOverlaps = true;
  Image marked = render::renderPicture(renderer(), frame, kAllLayers, 4096, progress);
  int both = 0, other = 0;
  eachShown(plain, [&](glm::ivec2 pixel, glm::vec3 p) {
    double a = 6.0 - double(p.y), b = -4.0 - double(p.x);
    bool isShared = a > 0.4 && a < 8.6 && b > 0.4 && b < 8.6;
    bool isClear = a < -0.4 || b < -0.4 || a > 9.4 || b > 9.4;
    glm::vec4 was = colorOf(plain, pixel), is = colorOf(marked, pixel);
    if (isShared) {
      ++both;
      EXPECT_GT(is.g - is.r, was.g - was.r + 0.1f) << "green";
    } else if (isClear) {
      ++other;
      EXPECT_EQ(is, was);
    }
  });
  EXPECT_GT(both, 12);
  EXPECT_GT(other, 200);
}

}  // namespace
}  // namespace velum
