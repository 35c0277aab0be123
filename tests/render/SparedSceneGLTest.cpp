// Picture, sections, kept voxels and picking leave the same of a structure that cuts spare.
#include "NaiveCuts.h"
#include "RenderFixture.h"
#include "render/kept/KeptVoxels.h"
#include "render/section/SectionImage.h"
#include "render/upload/CutGrid.h"
#include "scene/StructureAt.h"

namespace velum {
namespace {

constexpr glm::ivec3 kSparedSceneDims(40, 36, 44);
constexpr glm::ivec2 kSparedSceneSize(72, 72);

/// A block with a ball of structure 4 in it; the plane takes all before y = 4, towards the eye.
class SparedScene : public RenderTest {
 protected:
  void SetUp() override {
    RenderTest::SetUp();
    mScene = sceneOf(makeVolume(
        kSparedSceneDims, SampleType::UInt8, [](glm::ivec3) { return 100; }, centredFrame(kSparedSceneDims)));
    makeSolid(mScene);
    auto inBall = [](glm::ivec3 p) { return glm::length(glm::dvec3(p) - glm::dvec3(20, 10, 22)) < 7; };
    mScene.labels.data = Shared<LabelVolume>(makeLabels(
        kSparedSceneDims, [&](glm::ivec3 p) { return inBall(p) ? 4 : 0; }, mScene.volume.data->worldFromVoxel));
    scene::completeStructures(mScene.labels);
    scene::Cut plane;
    plane.centre = {0, 4, 0};
    plane.axis = {0, -1, 0};
    scene::addCut(mScene, plane);
  }

  int structureAt(glm::dvec3 world) const {
    if (!mScene.labels.visible) return 0;
    mField = scene::structureFieldOf(mScene);  // held: one is asked for each place
    return scene::structureAt(mScene, world).id;
  }

  /// Picture, sections, kept voxels (which exports write) and picking say the same as the naive fold.
  void expectSameEverywhere(const std::string& what) {
    SCOPED_TRACE(what);
    Progress progress;
    auto kept = render::keptVoxels(mScene, kSparedSceneDims, mScene.volume.data->worldFromVoxel, progress);
    std::size_t i = 0;
    int keptCount = 0;
    for (int z = 0; z < kSparedSceneDims.z; ++z)
      for (int y = 0; y < kSparedSceneDims.y; ++y)
        for (int x = 0; x < kSparedSceneDims.x; ++x, ++i) {
          glm::dvec3 world(mScene.volume.data->worldFromVoxel * glm::dvec4(x, y, z, 1.0));
          Naive wanted = naive(mScene, world, structureAt(world));
          keptCount += kept[i];
          if (wanted.isDoubtful) continue;
          ASSERT_EQ(kept[i] != 0, wanted.keeps) << x << ", " << y << ", " << z;
        }
    expectSection();
    expectPicture(keptCount > 0);
  }

 private:
  void expectSection() {
    scene::Scene bare = mScene;
    bare.cuts.clear();
    auto view = scene::makeSectionPlane(mScene, scene::SectionKind::Axial, glm::dvec2(kSparedSceneSize));
    auto image = render::drawSection(mScene, view), whole = render::drawSection(bare, view);
    for (int y = 0; y < kSparedSceneSize.y; ++y)
      for (int x = 0; x < kSparedSceneSize.x; ++x) {
        glm::dvec3 world = scene::worldFromSectionPixel(view, {x + 0.5, y + 0.5});
        glm::dvec3 voxel(glm::inverse(mScene.volume.data->worldFromVoxel) * glm::dvec4(world, 1.0));
        if (glm::any(glm::lessThan(voxel, glm::dvec3(0.5))) ||
            glm::any(glm::greaterThan(voxel, glm::dvec3(kSparedSceneDims) - 1.5)))
          continue;
        glm::dvec3 off = glm::abs(glm::fract(voxel + 0.5) - 0.5);
        Naive wanted = naive(mScene, world, structureAt(world));
        if (wanted.isDoubtful || std::max(off.x, std::max(off.y, off.z)) > 0.45) continue;  // on a label's border
        auto at = std::size_t(y * kSparedSceneSize.x + x);
        ASSERT_EQ(image.pixels[at] == whole.pixels[at], wanted.keeps) << "section at " << x << ", " << y;
      }
  }

  /// Along each ray of an orthographic picture the first place that is kept is what shows.
  void expectPicture(bool showsAny) {
    mScene.camera.projection = scene::Projection::Orthographic;
    mScene.camera.height = 60;
    lookAlong(mScene, {0, -1, 0});
    Image image = draw(mScene, kSparedSceneSize, kAllLayers);
    int shown = 0, rays = 0, slivers = 0;
    for (int y = 2; y + 2 < kSparedSceneSize.y; y += 3)
      for (int x = 2; x + 2 < kSparedSceneSize.x; x += 3) {
        TestRay ray = rayThrough(mScene.camera, kSparedSceneSize, glm::dvec2(x, y) + 0.5);
        glm::dvec2 box = boxInterval(*mScene.volume.data, ray);
        // Segments are half a voxel, and what is spared is asked in their middles: thinner slivers may be stepped over.
        double found = -1, since = -1;
        bool hasSliver = false;
        for (double t = box.x + 0.02; t < box.y && found < 0; t += 0.05) {
          bool keeps = naive(mScene, ray.at(t), structureAt(ray.at(t))).keeps;
          hasSliver = hasSliver || (since >= 0 && !keeps);
          since = !keeps ? -1 : since < 0 ? t : since;
          if (since >= 0 && t - since > 0.6) found = since;
        }
        ++(hasSliver ? slivers : rays);
        if (hasSliver) continue;
        bool isShown = sampleOf(image, {x, y}, "A") > 0.5f;
        ASSERT_EQ(isShown, found >= 0) << "picture at " << x << ", " << y;
        if (!isShown) continue;
        ++shown;
        glm::dvec3 wanted = ray.at(found), is(vectorOf(image, {x, y}, "position"));
        ASSERT_LT(glm::length(wanted - is), 0.6) << "picture at " << x << ", " << y;
      }
    EXPECT_LT(slivers, rays / 10);
    EXPECT_EQ(shown > 0, showsAny);
  }

 protected:
  scene::Scene mScene;
  mutable std::shared_ptr<const StructureField> mField;
};

TEST_F(SparedScene, AStructureIsSparedWholeOrSoDeep) {
  mScene.cuts[0].spares = {{4}};
  expectSameEverywhere("whole");
  mScene.cuts[0].spares = {{4, 5.2}};
  expectSameEverywhere("so deep");
}

TEST_F(SparedScene, WhatHasNoLabelIsSparedAlikeEverywhere) {
  mScene.cuts[0].spares = {{0}};
  expectSameEverywhere("whole");
  mScene.cuts[0].spares = {{0, 3.3}};
  expectSameEverywhere("so deep");
}

TEST_F(SparedScene, WithoutLabelsNothingHasOne) {
  mScene.cuts[0].spares = {{0, 6.7}, {4}};
  mScene.labels.visible = false;
  expectSameEverywhere("labels that are not shown");
  mScene.labels = {};
  mScene.labels.visible = false;
  expectSameEverywhere("no labels");
}

TEST_F(SparedScene, SeveralCutsSpareEachForItself) {
  scene::Cut ball;
  ball.shape = scene::CutShape::Sphere;
  ball.centre = {4, 3, 2};
  ball.size = glm::dvec3(24);
  ball.spares = {{0, 2.4}, {4, 4.1}};
  scene::addCut(mScene, ball);
  mScene.cuts[0].spares = {{4, 9.3}, {0, 1.7}};
  expectSameEverywhere("plane and ball");
  mScene.cuts[1].invert = true;
  expectSameEverywhere("plane and all around a ball");
}

/// So many that a grid says which of them matter where.
TEST_F(SparedScene, AmongManyCutsEachSparesForItself) {
  mScene.cuts[0].spares = {{4, 9.3}, {0, 1.7}};
  for (int i = 0; i < 12; ++i) {
    scene::Cut ball;
    ball.shape = i % 3 == 0 ? scene::CutShape::Box : scene::CutShape::Sphere;
    ball.centre = {12 * std::sin(i * 1.3), 12 * std::cos(i * 2.1), 10 * std::sin(i * 0.7)};
    ball.size = glm::dvec3(9);
    if (i % 2 == 0) ball.spares = {{4, 1.0 + i}};
    if (i % 4 == 1) ball.spares = {{0}};
    scene::addCut(mScene, ball);
  }
  ASSERT_GE(mScene.cuts.size(), render::kFewCuts);
  expectSameEverywhere("twelve balls and boxes");
}

}  // namespace
}  // namespace velum
