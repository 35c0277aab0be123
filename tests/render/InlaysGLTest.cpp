// Inlays in pictures: what is before, on and behind them, and their image.
#include "MembranesFixture.h"

namespace velum {
namespace {

/// A soft block in which an inlay with a folded and a waving sheet hangs.
class InlaysGL : public MembranesGL {
 protected:
  static scene::Scene sectionScene(double opacity = 0.5) {
    scene::Scene scene = softScene();
    scene.lighting.shadow = scene.lighting.occlusion = 0;
    scene.volume.windowLevel = 300;
    scene.volume.windowWidth = 700;
    scene.cuts = {membraneOf(wavySheet(kParticles, kFrame), {0, -1, 0})};
    scene.cuts[0].membrane->use = scene::MembraneUse::Inlay;
    scene.cuts[0].membrane->inlayOpacity = opacity;
    return scene;
  }
  static scene::Membrane& membrane(scene::Scene& scene) { return *scene.cuts[0].membrane; }
  /// Pixels whose position lies before, on and behind the inlay.
  struct Sides {
    int front = 0, on = 0, behind = 0;
  };
  Sides sidesOf(const scene::Scene& scene) {
    Image image = draw(scene, kSize, kAllLayers);
    glm::dmat4 local = glm::inverse(scene::worldFromCut(scene.cuts[0]));
    Sides sides;
    eachShown(image, [&](glm::ivec2, glm::vec3 p) {
      double z = (local * glm::dvec4(p, 1.0)).z;
      ++(z > 0.1 ? sides.front : z < -0.1 ? sides.behind : sides.on);
    });
    return sides;
  }
};

/// So many that a grid says which of them matter where, and none of them does.
TEST_F(InlaysGL, CutsFarAwayChangeNothing) {
  scene::Scene scene = sectionScene(0.7);
  scene.lighting.shadow = 0.5;
  for (scene::MembraneUse use : {scene::MembraneUse::Inlay, scene::MembraneUse::Clip}) {
    membrane(scene).use = use;
    scene::Scene many = scene;
    for (int i = 0; i < 20; ++i) {
      scene::Cut ball;
      ball.shape = scene::CutShape::Sphere;
      ball.centre = {300.0 + 20 * i, 200, 0};
      ball.size = glm::dvec3(10);
      scene::addCut(many, ball);
    }
    Image few = draw(scene, kSize, {}), all = draw(many, kSize, {});
    ASSERT_EQ(few.pixels.size(), all.pixels.size());
    for (std::size_t i = 0; i < few.pixels.size(); ++i) ASSERT_NEAR(few.pixels[i], all.pixels[i], 1e-3) << i;
  }
}

TEST_F(InlaysGL, EmphasisAtItsEndsShowsOneSideOnly) {
  scene::Scene scene = sectionScene(0.0);
  Sides both = sidesOf(scene);
  EXPECT_GT(both.front, 100);
  EXPECT_GT(both.behind, 100);
  membrane(scene).emphasis = -1;
  Sides behind = sidesOf(scene);
  EXPECT_EQ(behind.front, 0);
  EXPECT_GT(behind.behind, both.behind);
  membrane(scene).emphasis = 1;
  Sides front = sidesOf(scene);
  EXPECT_EQ(front.behind, 0);
  EXPECT_GT(front.front, 100);
  // Turned round, the other side is in front.
  scene.cuts[0].invert = true;
  EXPECT_EQ(sidesOf(scene).front, 0);
}

TEST_F(InlaysGL, NothingIsKeptButBetweenSheetAndInlay) {
  scene::Scene scene = sectionScene(0.0);
  Cuts cuts(scene);
  Image image = draw(scene, kSize, kAllLayers);
  int shown = eachShown(image, [&](glm::ivec2, glm::vec3 p) { EXPECT_GE(distanceTo(cuts, p), -0.02f); });
  EXPECT_GT(shown, 300);
}

TEST_F(InlaysGL, AnOpaqueInlayHidesWhatIsBehindIt) {
  scene::Scene scene = sectionScene(1.0);
  EXPECT_EQ(sidesOf(scene).behind, 0);
  Image with = draw(scene);
  membrane(scene).emphasis = 1;  // what is behind is not even there
  // Where the sheet touches the section, rounding tells which side a sample is on.
  EXPECT_LT(differenceOf(draw(scene), with).mean, 0.01);
  // From behind, the side in front is hidden.
  membrane(scene).emphasis = 0;
  lookAlong(scene, {0.1, 1, 0.2}, 100);
  EXPECT_EQ(sidesOf(scene).front, 0);
}

TEST_F(InlaysGL, TheImageHasTheGreyOfItsVoxels) {
  // Values that change along x and z only, so that the section's depth does not matter.
  Volume v = makeVolume(
      kDims, SampleType::Int16, [](glm::ivec3 p) { return -200.0 + 20 * p.x + 10 * p.z; }, centredFrame(kDims));
  glm::dmat4 voxelFromWorld = glm::inverse(v.worldFromVoxel);
  scene::Scene scene = sceneOf(std::move(v));
  scene.volume.transfer.opacities = {{-200, 0}, {2000, 0}};
  scene.volume.windowLevel = 350;
  scene.volume.windowWidth = 700;
  scene.cuts = {membraneOf(domeSheet(kParticles, kFrame), {0, -1, 0})};
  scene.cuts[0].membrane->use = scene::MembraneUse::Inlay;
  glm::dmat4 local = glm::inverse(scene::worldFromCut(scene.cuts[0]));
  for (double opacity : {1.0, 0.5}) {
    scene.cuts[0].membrane->inlayOpacity = opacity;
    Image image = draw(scene, kSize, kAllLayers);
    int checked = 0;
    for (int y = 0; y < kSize.y; ++y)
      for (int x = 0; x < kSize.x; ++x) {
        if (sampleOf(image, {x, y}, "A") == 0.0f) continue;
        glm::dvec3 p(vectorOf(image, {x, y}, "position")), q(local * glm::dvec4(p, 1.0));
        EXPECT_NEAR(q.z, 0, 1e-3);
        EXPECT_LE(std::abs(q.x), 17.01);
        EXPECT_LE(std::abs(q.y), 19.01);
        glm::dvec3 voxel(voxelFromWorld * glm::dvec4(p, 1.0)), last = glm::dvec3(kDims) - 1.0;
        if (glm::any(glm::lessThan(voxel, glm::dvec3(0.0))) || glm::any(glm::greaterThan(voxel, last))) continue;
        ++checked;
        double grey = glm::clamp((-200.0 + 20 * voxel.x + 10 * voxel.z) / 700.0, 0.0, 1.0);
        EXPECT_NEAR(sampleOf(image, {x, y}, "R") * 255, grey * 255, 1.5 / opacity) << x << ", " << y;
        EXPECT_NEAR(sampleOf(image, {x, y}, "A"), opacity, 1.01 / 255);
      }
    EXPECT_GT(checked, 800);
  }
}

TEST_F(InlaysGL, AShorterFallOffNeverShowsMore) {
  scene::Scene scene = sectionScene(0.0);
  scene.lighting.shaded = false;
  Image before;
  for (double falloff : {2.0, 4.0, 7.0, 11.0, 40.0}) {
    membrane(scene).falloff = falloff;
    Image image = draw(scene, kSize);
    double more = 0;
    for (int y = 0; y < kSize.y && before.width > 0; ++y)
      for (int x = 0; x < kSize.x; ++x) {
        double change = sampleOf(image, {x, y}, "A") - sampleOf(before, {x, y}, "A");
        EXPECT_GE(change, -1.5 / 255) << falloff << " mm at " << x << ", " << y;
        more += change;
      }
    EXPECT_TRUE(before.width == 0 || more > 1.0) << falloff;
    before = image;
  }
  membrane(scene).falloff = 11;
  Image reach = draw(scene, kSize);
  membrane(scene).falloff = 0;
  expectSame(draw(scene, kSize), reach, 0.0, "0 is the reach");
}

TEST_F(InlaysGL, WhatOneSparesDoesNotFadeBesideIt) {
  scene::Scene scene = solidScene(0.0);
  lookAlong(scene, {0, -1, 0}, 100);
  const glm::dvec3 middle(1, -8, -1);  // before the inlay, farther off than its fall-off
  const glm::dmat4 frame = scene.volume.data->worldFromVoxel;
  scene.labels.data = Shared<LabelVolume>(makeLabels(
      kDims, [&](glm::ivec3 p) { return glm::distance(glm::dvec3(frame * glm::dvec4(p, 1.0)), middle) < 6 ? 4 : 0; },
      frame));
  scene::completeStructures(scene.labels);
  scene.cuts = {membraneOf(flatSheet(kParticles, kFrame), {0, -1, 0})};
  scene.cuts[0].membrane->use = scene::MembraneUse::Inlay;
  membrane(scene).inlayOpacity = 0.0;
  membrane(scene).falloff = 2.0;
  EXPECT_EQ(coverageOf(draw(scene, kSize)), 0.0) << "nothing lies between a flat sheet and its inlay";
  scene.cuts[0].spares = {{4}};
  Image image = draw(scene, kSize);
  int through = 0;
  for (int y = 0; y < kSize.y; ++y)
    for (int x = 0; x < kSize.x; ++x) {
      TestRay ray = rayThrough(scene.camera, kSize, {x + 0.5, y + 0.5});
      double off = glm::length(glm::cross(middle - ray.origin, ray.direction));
      if (off > 7.5) {
        EXPECT_EQ(sampleOf(image, {x, y}, "A"), 0.0f) << x << ", " << y;
      }
      if (off > 4.5) continue;
      ++through;
      EXPECT_GT(sampleOf(image, {x, y}, "A"), 0.98f) << x << ", " << y;
    }
  EXPECT_GT(through, 60);
}

TEST_F(InlaysGL, SeveralAddUpAndOtherCutsTakeTheirImages) {
  scene::Scene one = sectionScene(0.9);
  lookAlong(one, {0.5, -1, 0.9}, 100);
  scene::Scene two = one, other = one;
  other.cuts[0].axis = {0, 0, 1};
  other.cuts[0].membrane->shape = domeSheet(kParticles, kFrame);
  scene::addCut(two, other.cuts[0]);
  double a = coverageOf(draw(one)), b = coverageOf(draw(other)), both = coverageOf(draw(two));
  EXPECT_GT(both, std::max(a, b) + 0.01);
  EXPECT_LE(both, a + b);
  scene::Scene cut = one;
  scene::Cut half;
  half.axis = {1, 0, 0};
  half.centre = cut.cuts[0].centre;
  cut.cuts.push_back(half);
  Image image = draw(cut, kSize, kAllLayers);
  int shown = eachShown(image, [&](glm::ivec2, glm::vec3 p) { EXPECT_LE(p.x, half.centre.x + 0.1); });
  EXPECT_GT(shown, 200);
}

TEST_F(InlaysGL, AMaximumStandsOutOfTheInlayAndAnOpaqueInlayEndsIt) {
  scene::Scene scene = sectionScene(1.0);
  scene.rayCast.mode = scene::RenderMode::Mip;
  Image both = draw(scene, kSize);
  membrane(scene).emphasis = 1;
  expectSame(draw(scene, kSize), both, 1.0, "nothing behind an opaque section");
  membrane(scene).emphasis = -1;
  Image section = draw(scene, kSize);
  double brighter = 0;
  for (int y = 0; y < kSize.y; ++y)
    for (int x = 0; x < kSize.x; ++x) {
      double change = sampleOf(both, {x, y}, "R") - sampleOf(section, {x, y}, "R");
      EXPECT_GE(change, -1.5 / 255);
      brighter += change;
    }
  EXPECT_GT(brighter, 10.0);
}

TEST_F(InlaysGL, AMaximumBehindTwoInlaysShowsAsBehindOneThatLetsThroughAsMuch) {
  // Both inlays lie in material of one grey, what is brighter lies behind them.
  scene::Scene scene = sceneOf(makeVolume(
      kDims, SampleType::UInt8, [](glm::ivec3 p) { return p.y > 28 ? 250.0 : 100.0; }, centredFrame(kDims)));
  scene.volume.windowLevel = 150;
  scene.volume.windowWidth = 300;
  scene.rayCast.mode = scene::RenderMode::Mip;
  lookAlong(scene, {0, -1, 0}, 100);
  scene::SheetShape flat = wavySheet(kParticles, kFrame);
  for (glm::vec3& place : flat.places) place.z = 0.0f;
  for (double y : {-6.0, 2.0}) {
    scene::Cut cut = membraneOf(flat, {0, -1, 0});
    cut.centre = {0, y, 0};
    cut.membrane->use = scene::MembraneUse::Inlay;
    cut.membrane->inlayOpacity = 0.5;
    scene::addCut(scene, cut);
  }
  Image both = draw(scene, kSize);
  scene.cuts[1].enabled = false;
  membrane(scene).inlayOpacity = 0.75;
  Image one = draw(scene, kSize);
  for (glm::ivec2 p(28); p.y < 36; ++p.y)
    for (p.x = 28; p.x < 36; ++p.x) {
      EXPECT_NEAR(sampleOf(both, p, "R"), sampleOf(one, p, "R"), 1.5 / 255);
      EXPECT_GT(sampleOf(both, p, "R"), 0.3f);
    }
}

}  // namespace
}  // namespace velum
