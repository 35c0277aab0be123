// Membranes in pictures: what they remove is what shaders/shared/sheet.h says on the processor.
#include "MembranesFixture.h"

namespace velum {
namespace {

TEST_F(MembranesGL, AFlatOneGivesThePictureOfThePlane) {
  for (int mode = 0; mode < 3; ++mode)
    for (glm::dvec3 eye : {glm::dvec3(0.35, -1, 0.3), glm::dvec3(0.2, 1, 0.4), glm::dvec3(1, 0.05, 0.1)})
      for (bool invert : {false, true}) {
        scene::Scene scene = softScene(), plane;
        // The light grid takes a second; once is enough.
        if (mode != 0 || invert) scene.lighting.shadow = scene.lighting.occlusion = 0;
        scene.rayCast.mode = scene::RenderMode(mode);
        scene.rayCast.isoValue = 420;
        lookAlong(scene, eye, 100);
        scene.cuts = {membraneOf({})};
        scene.cuts[0].invert = invert;
        plane = scene;
        plane.cuts = {planeOf(scene.cuts[0])};
        std::string what = "mode " + std::to_string(mode) + (invert ? " inverted" : "");
        if (mode == 0) {
          // A membrane is lit as the data's edges are where it lies along one.
          EXPECT_LT(differenceOf(draw(scene, kSize), draw(plane, kSize)).mean, 1.0) << what;
          scene.lighting.shaded = plane.lighting.shaded = false;
        }
        Image whole = draw(plane, kSize, kAllLayers), image = draw(scene, kSize, kAllLayers);
        // Both meet a ray in places that differ in the last digits, by which thin material may be taken together
        // otherwise: that moves a pixel or two by two grey levels.
        expectSame(image, whole, mode == 0 ? 2.0 : 1.0, what);
      }
}

TEST_F(MembranesGL, EverySheetRemovesWhatTheProcessorSays) {
  const std::pair<const char*, glm::dvec3> kViews[] = {
      {"front", {0.35, -1, 0.3}}, {"behind", {0.1, 1, 0.2}}, {"along", {1, 0.2, 0.05}}};
  for (const auto& [name, shape] : allSheets(kParticles, kFrame))
    for (auto [view, eye] : kViews)
      for (bool invert : {false, true}) {
        scene::Scene scene = solidScene();
        scene.camera.projection = invert ? scene::Projection::Orthographic : scene::Projection::Perspective;
        scene.camera.height = 55;
        lookAlong(scene, eye, 100);
        scene.cuts = {membraneOf(shape)};
        scene.cuts[0].invert = invert;
        expectAgrees(scene, name + " from " + view + (invert ? " inverted" : ""));
      }
}

TEST_F(MembranesGL, AnEyeInsideSeesTheSame) {
  for (const auto& [name, shape] : allSheets(kParticles, kFrame)) {
    scene::Scene scene = solidScene();
    scene.camera.fieldOfViewDeg = 90;
    scene.cuts = {membraneOf(shape)};
    for (glm::dvec3 eye : {glm::dvec3(2, -8, 1), glm::dvec3(-4, -3, 5), glm::dvec3(3, 9, -2)}) {
      scene.camera.eye = eye;
      scene.camera.target = eye + glm::dvec3(-3, 10, 2);
      expectAgrees(scene, name + " from inside");
    }
  }
}

TEST_F(MembranesGL, SeveralAndOtherCutsTogether) {
  scene::Scene scene = solidScene();
  scene.cuts = {membraneOf(wavySheet(kParticles, kFrame)),
                membraneOf(foldedSheet({30, 30}, {30, 30, 20}), {1, 0.3, 0.2}, {30, 30, 20})};
  scene.cuts[1].centre = {12, 0, 0};
  scene::completeItems(scene);
  expectAgrees(scene, "two membranes");
  scene::Cut box;
  box.shape = scene::CutShape::Box;
  box.centre = {-6, 4, 8};
  box.size = {14, 30, 14};
  scene.cuts.push_back(box);
  expectAgrees(scene, "two membranes and a box");
  scene.cuts[0].enabled = false;
  expectAgrees(scene, "one of them off");
}

TEST_F(MembranesGL, LeapingAndEarlyEndsChangeNothing) {
  for (int mode = 0; mode < 3; ++mode)
    for (auto use : {scene::MembraneUse::Clip, scene::MembraneUse::Inlay}) {
      scene::Scene scene = softScene();
      scene.lighting.shadow = scene.lighting.occlusion = 0;
      scene.rayCast.mode = scene::RenderMode(mode);
      scene.rayCast.isoValue = 420;
      scene.cuts = {membraneOf(foldedSheet({30, 30}, kFrame))};
      scene.cuts[0].membrane->use = use;
      scene.cuts[0].membrane->look = scene::SheetLook::Surface;
      Image fast = draw(scene);
      scene.rayCast.skipEmpty = scene.rayCast.stopOpaque = false;
      expectSame(fast, draw(scene), 1.5, "mode " + std::to_string(mode) + " use " + std::to_string(int(use)));
    }
}

TEST_F(MembranesGL, TheFaceHasTheNormalOfTheSheet) {
  scene::Scene scene = solidScene(0.0);
  scene.lighting.shaded = true;
  scene.lighting.shadow = scene.lighting.occlusion = 0;
  // z = h (1 - u^2)(1 - v^2) in the frame, whose normal is known.
  scene.cuts = {membraneOf(domeSheet({60, 60}, kFrame), {0, -1, 0})};
  glm::dmat4 world = scene::worldFromCut(scene.cuts[0]);
  Image image = draw(scene, kSize, kAllLayers);
  int onFace = 0;
  for (int y = 0; y < kSize.y; ++y)
    for (int x = 0; x < kSize.x; ++x) {
      if (sampleOf(image, {x, y}, "A") == 0.0f) continue;
      glm::dvec3 p(glm::inverse(world) * glm::dvec4(vectorOf(image, {x, y}, "position"), 1.0));
      double u = p.x / 17, v = p.y / 19, h = 0.8 * 11;
      if (std::max(std::abs(u), std::abs(v)) > 0.9 || std::abs(p.z - h * (1 - u * u) * (1 - v * v)) > 0.4) continue;
      glm::dvec3 normal = glm::normalize(glm::dvec3(h * 2 * u * (1 - v * v) / 17, h * 2 * v * (1 - u * u) / 19, 1.0));
      EXPECT_GT(glm::dot(glm::dmat3(world) * normal, glm::dvec3(vectorOf(image, {x, y}, "normal"))), 0.995)
          << x << ", " << y;
      ++onFace;
    }
  EXPECT_GT(onFace, 400);
}

TEST_F(MembranesGL, WhatItSparesStaysWhole) {
  scene::Scene scene = solidScene(0.0);
  auto inBall = [](glm::ivec3 p) { return glm::length(glm::dvec3(p) - glm::dvec3(20, 10, 22)) < 7; };
  scene.labels.data = Shared<LabelVolume>(makeLabels(
      kDims, [&](glm::ivec3 p) { return inBall(p) ? 4 : 0; }, scene.volume.data->worldFromVoxel));
  scene::completeStructures(scene.labels);
  // The sheet dents inwards, so that all of the ball is above it.
  scene::SheetShape bowl = domeSheet(kParticles, kFrame);
  for (auto& p : bowl.places) p.z = -p.z;
  scene.cuts = {membraneOf(bowl, {0, -1, 0})};
  scene.cuts[0].spares = {{4}};
  Cuts cuts(scene);
  Image image = draw(scene, kSize, kAllLayers);
  int spared = 0;
  for (int y = 0; y < kSize.y; ++y)
    for (int x = 0; x < kSize.x; ++x) {
      if (sampleOf(image, {x, y}, "A") == 0.0f) continue;
      glm::vec3 p = vectorOf(image, {x, y}, "position");
      bool isRemoved = shared::cutDistance(cuts.data[0], p, cuts.sheets.view()) < -0.05f;
      bool isBall = std::lround(sampleOf(image, {x, y}, "id")) == 4;
      EXPECT_TRUE(isBall || !isRemoved) << x << ", " << y;
      spared += isRemoved && isBall;
    }
  EXPECT_GT(spared, 150);
}

TEST_F(MembranesGL, ALiveSheetShowsAsItsShapeWouldAndItsStepsMakeFramesDiffer) {
  scene::Scene saved = softScene();
  saved.cuts = {membraneOf(wavySheet(kParticles, kFrame))};
  Image wanted = draw(saved);
  render::Frame frame = frameOf(saved, {96, 96});
  frame.scene.cuts[0].membrane->shape = {};
  auto sheet = std::make_shared<membrane::Sheet>(scene::SheetShape{}, kParticles, kFrame);
  frame.sheets[frame.scene.cuts[0].id] = {sheet, sheet->revision()};
  Progress progress;
  renderer().render(frame, progress);
  Image flat = renderer().read();
  EXPECT_GT(differenceOf(flat, wanted).mean, 0.5);
  sheet->setShape(saved.cuts[0].membrane->shape, kParticles, kFrame);
  EXPECT_TRUE(renderer().work(frame, 0.0)) << "a frame is a moment: this one is complete";
  frame.sheets[frame.scene.cuts[0].id] = {sheet, sheet->revision()};
  renderer().render(frame, progress);
  expectSame(renderer().read(), wanted, 1.0, "live");
  // Made for another frame it is not this cut's.
  frame.scene.cuts[0].size.x += 1;
  frame.scene.cuts[0].membrane->shape = saved.cuts[0].membrane->shape;
  EXPECT_NO_THROW(renderer().render(frame, progress));
  saved.cuts[0].size.x += 1;
  Image other = renderer().read();
  expectSame(other, draw(saved), 0.0, "of another frame");
}

TEST_F(MembranesGL, ShadowsFollowASheetThatMoves) {
  scene::Scene wavy = softScene();
  wavy.lighting.shadow = wavy.lighting.occlusion = 1.0;
  wavy.cuts = {membraneOf(wavySheet(kParticles, kFrame))};
  scene::Scene flat = wavy;
  for (glm::vec3& place : flat.cuts[0].membrane->shape.places) place.z = -0.3f * float(kFrame.z);
  // After other data nothing is kept.
  auto anew = [&](const scene::Scene& scene) {
    draw(sceneOf(makeVolume({4, 5, 6}, SampleType::UInt8, [](glm::ivec3 p) { return 40.0 * p.x; })));
    return draw(scene);
  };
  Image first = anew(wavy), moved = draw(flat);
  EXPECT_GT(differenceOf(first, moved).mean, 0.5);
  expectSame(moved, anew(flat), 0.0, "after the sheet has moved");
}

TEST_F(MembranesGL, ASheetIsShownWhereItIsAndCanBePicked) {
  for (auto look : {scene::SheetLook::Surface, scene::SheetLook::Grid}) {
    scene::Scene scene = softScene();
    scene.volume.transfer.opacities = {{0, 0}, {1000, 0}};
    scene.cuts = {membraneOf(foldedSheet({40, 40}, kFrame))};
    EXPECT_EQ(coverageOf(draw(scene, kSize)), 0.0);
    scene.cuts[0].membrane->look = look;
    Cuts cuts(scene);
    Image image = draw(scene, kSize, kAllLayers);
    int shown = eachShown(image, [&](glm::ivec2 pixel, glm::vec3 p) {
      EXPECT_LT(std::abs(distanceTo(cuts, p)), 0.02f) << pixel.x << ", " << pixel.y;
      render::Pick pick = renderer().pick(pixel);
      EXPECT_TRUE(pick.hit);
      EXPECT_LT(glm::length(glm::vec3(pick.world) - p), 1e-3f);
    });
    EXPECT_GT(shown, 500) << int(look);
  }
}

TEST_F(MembranesGL, SurfacesAreCutToo) {
  scene::Scene scene = softScene();
  scene.volume.visible = false;
  scene::Surface surface;
  Mesh mesh;
  for (int i = 0; i < 20; ++i)
    for (int k = 0; k < 20; ++k)
      for (glm::vec2 c :
           {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 0), glm::vec2(1, 1), glm::vec2(0, 1)})
        mesh.positions.emplace_back(0.3f, 2 * (i + c.x) - 20, 2 * (k + c.y) - 20);
  for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) mesh.indices.push_back(i);
  surface.data = Shared<Mesh>(std::move(mesh));
  scene.surfaces = {surface};
  lookAlong(scene, {1, 0, 0}, 100);
  scene.cuts = {membraneOf(wavySheet(kParticles, kFrame))};
  Cuts cuts(scene);
  Image image = draw(scene, kSize, kAllLayers);
  int shown = eachShown(
      image, [&](glm::ivec2, glm::vec3 p) { EXPECT_GE(distanceTo(cuts, p), -0.02f); }, 0.5f);
  EXPECT_GT(shown, 200);
}

}  // namespace
}  // namespace velum
