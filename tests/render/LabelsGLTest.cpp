// What labels do to a picture.
#include "RenderFixture.h"

namespace velum {
namespace {

constexpr glm::ivec3 kLabelsDims(32, 32, 32);
constexpr glm::ivec2 kLabelsSize(64, 64);
constexpr glm::ivec2 kLeft(16, 32), kRight(48, 32);

class LabelsGL : public RenderTest {
 protected:
  /// A solid block about a place, red by the transfer function; label 1 on its left half, label 300 on the right one.
  /// Orthographic from the front.
  static scene::Scene halves(const glm::dmat4& labelFrame, glm::ivec3 labelDims, glm::dvec3 place = glm::dvec3(0)) {
    scene::Scene scene = sceneOf(makeVolume(
        kLabelsDims, SampleType::UInt8, [](glm::ivec3) { return 100.0; },
        centredFrame(kLabelsDims, glm::dvec3(1), 0, place)));
    makeSolid(scene, {1, 0, 0});
    LabelVolume labels = makeLabels(
        labelDims, [&](glm::ivec3 p) { return (labelFrame * glm::dvec4(p, 1.0)).x < place.x ? 1 : 300; }, labelFrame);
    labels.table = {{1, "left", {0, 1, 0}, 1.0f}, {300, "right", {0, 0, 1}, 1.0f}};
    scene.labels.data = Shared<LabelVolume>(std::move(labels));
    scene::completeStructures(scene.labels);
    scene.camera.projection = scene::Projection::Orthographic;
    scene.camera.height = 32;
    scene.camera.eye += place - scene.camera.target;
    scene.camera.target = place;
    return scene;
  }
  static scene::Scene halves() { return halves(centredFrame(kLabelsDims), kLabelsDims); }
};

TEST_F(LabelsGL, TintTurnsTheColourIntoTheStructures) {
  scene::Scene scene = halves();
  for (double tint : {0.0, 0.5, 1.0}) {
    scene.labels.tint = tint;
    Image image = draw(scene, kLabelsSize, kAllLayers);
    glm::vec4 left = colorOf(image, kLeft), right = colorOf(image, kRight);
    EXPECT_NEAR(left.r, 1 - tint, 0.01);
    EXPECT_NEAR(left.g, tint, 0.01);
    EXPECT_NEAR(right.r, 1 - tint, 0.01);
    EXPECT_NEAR(right.b, tint, 0.01);
    EXPECT_EQ(sampleOf(image, kLeft, "id"), 1.0f);
    EXPECT_EQ(sampleOf(image, kRight, "id"), 300.0f);
    EXPECT_EQ(renderer().pick(kRight).structure, 300);
  }
}

/// Bone shows half a voxel before its label begins, where voxels are muscle's: its colour is its own all the same. And
/// so is that of a skin less than two voxels thick, in air: it has none of the fat under it.
TEST_F(LabelsGL, AtABorderWhoIsBehindTheSurfaceLendsTheColour) {
  auto fromMiddle = [](glm::ivec3 p) { return glm::length(glm::dvec3(p) - 0.5 * glm::dvec3(kLabelsDims - 1)); };
  scene::Scene scene = sceneOf(makeVolume(
      kLabelsDims, SampleType::UInt8, [&](glm::ivec3 p) { return 100.0 * std::erfc(fromMiddle(p) - 10.0); },
      centredFrame(kLabelsDims)));
  scene.volume.transfer.colors = {{0, {1, 0, 0}}};
  scene.volume.transfer.opacities = {{50, 0}, {60, 0.95}};
  scene.volume.transfer.unitDistance = 0.1;
  scene.rayCast.isoValue = 50;
  scene.lighting.shaded = true;
  scene.lighting.specular = 0;
  auto boneInMuscle = [&](glm::ivec3 p) { return fromMiddle(p) < 10.0 ? 1 : 2; };
  auto skinOnFat = [&](glm::ivec3 p) { return fromMiddle(p) < 8.3 ? 2 : fromMiddle(p) < 10.0 ? 1 : 0; };
  auto countOthers = [&](auto labelOf, scene::RenderMode mode) {
    LabelVolume labels = makeLabels(kLabelsDims, labelOf, centredFrame(kLabelsDims));
    labels.table = {{1, "bone or skin", {0, 1, 0}, 1.0f}, {2, "muscle or fat", {0, 0, 1}, 1.0f}};
    scene.labels.data = Shared<LabelVolume>(std::move(labels));
    scene::completeStructures(scene.labels);
    scene.rayCast.mode = mode;
    Image image = draw(scene, kLabelsSize, kAllLayers);
    int others = 0;
    int shown = eachShown(
        image,
        [&](glm::ivec2 pixel, glm::vec3) {
          glm::vec4 color = colorOf(image, pixel);
          others += color.b > color.g;
        },
        0.9f);
    EXPECT_GT(shown, 300) << enumName(mode);
    EXPECT_LT(others, shown / 50) << enumName(mode);
  };
  for (auto mode : {scene::RenderMode::Volume, scene::RenderMode::Iso}) {
    countOthers(boneInMuscle, mode);
    countOthers(skinOnFat, mode);
  }
}

TEST_F(LabelsGL, AStructureWithoutOpacityIsHidden) {
  for (bool byOpacity : {true, false})
    for (int mode = 0; mode < 3; ++mode) {
      scene::Scene scene = halves();
      scene.rayCast.mode = scene::RenderMode(mode);
      scene.rayCast.isoValue = 50;
      scene.volume.windowLevel = 50;
      scene.volume.windowWidth = 100;
      if (mode == 2) {
        // An isosurface needs a crossing: a block within air.
        scene.volume.data = Shared<Volume>(makeVolume(
            kLabelsDims, SampleType::UInt8, [](glm::ivec3 p) { return p.y > 4 && p.y < 28 ? 100.0 : 0.0; },
            centredFrame(kLabelsDims)));
      }
      EXPECT_GT(colorOf(draw(scene, kLabelsSize), kRight).a, 0.9f) << "mode " << mode;
      if (byOpacity)
        scene.labels.structures[1].opacity = 0;
      else
        scene.labels.structures[1].visible = false;
      Image image = draw(scene, kLabelsSize);
      EXPECT_EQ(colorOf(image, kRight).a, 0.0f) << "mode " << mode;
      EXPECT_GT(colorOf(image, kLeft).a, 0.9f) << "mode " << mode;
      scene.labels.visible = false;
      EXPECT_GT(colorOf(draw(scene, kLabelsSize), kRight).a, 0.9f) << "labels that are off hide nothing, mode " << mode;
    }
}

TEST_F(LabelsGL, OpacityOfAStructureScalesItsExtinction) {
  scene::Scene scene = halves();
  scene.volume.transfer.opacities = {{0, 0.05}, {255, 0.05}};
  scene.volume.transfer.unitDistance = 1;
  scene.labels.structures[1].opacity = 0.5;
  Image image = draw(scene, kLabelsSize);
  EXPECT_NEAR(colorOf(image, kLeft).a, 1 - std::pow(0.95, 32), 1.01 / 255);
  EXPECT_NEAR(colorOf(image, kRight).a, 1 - std::pow(0.95, 16), 1.01 / 255);
}

TEST_F(LabelsGL, UnlabelledMaterialHasItsOwnFactor) {
  scene::Scene scene = halves();
  scene.labels.data = Shared<LabelVolume>(makeLabels(
      kLabelsDims, [](glm::ivec3 p) { return p.x < 16 ? 7 : 0; }, centredFrame(kLabelsDims)));
  scene.labels.structures.clear();
  scene::completeStructures(scene.labels);
  EXPECT_GT(colorOf(draw(scene, kLabelsSize), kRight).a, 0.9f);
  scene.labels.unlabelled = 0;
  Image image = draw(scene, kLabelsSize);
  EXPECT_EQ(colorOf(image, kRight).a, 0.0f);
  EXPECT_GT(colorOf(image, kLeft).a, 0.9f);
}

TEST_F(LabelsGL, OneStructureEverywhereChangesNothing) {
  for (double opacity : {0.01, 0.08, 0.9})
    for (bool shaded : {false, true}) {
      scene::Scene scene = sceneOf(makeVolume(
          kLabelsDims, SampleType::UInt8,
          [](glm::ivec3 p) { return 90 + 60 * std::sin(p.x * 0.4) * std::cos(p.z * 0.3); }, centredFrame(kLabelsDims)));
      scene.volume.transfer.colors = {{40, {0.2f, 0.5f, 1}}, {150, {1, 0.8f, 0.3f}}};
      scene.volume.transfer.opacities = {{60, 0}, {130, opacity}};
      scene.lighting.shaded = shaded;
      scene.lighting.shadow = scene.lighting.occlusion = 0;
      Image without = draw(scene, kLabelsSize);
      scene.labels.data = Shared<LabelVolume>(makeLabels(
          kLabelsDims, [](glm::ivec3) { return 7; }, centredFrame(kLabelsDims)));
      scene::completeStructures(scene.labels);
      scene.labels.tint = 0;
      EXPECT_GT(coverageOf(without), 0.1);
      expectSame(draw(scene, kLabelsSize), without, 1.0, "opacity " + std::to_string(opacity));
    }
}

TEST_F(LabelsGL, AThinStructureIsAsThickAsItIs) {
  // Fog through which segments may be shaded together: a voxel of it counts wherever it lies among them.
  for (double opacity : {0.01, 0.04})
    for (int y = 8; y < 16; ++y) {
      scene::Scene scene = halves();
      scene.volume.transfer.opacities = {{0, opacity}, {255, opacity}};
      scene.volume.transfer.unitDistance = 1;
      scene.labels.data = Shared<LabelVolume>(makeLabels(
          kLabelsDims, [y](glm::ivec3 p) { return p.y == y ? 7 : 0; }, centredFrame(kLabelsDims)));
      scene.labels.structures.clear();
      scene::completeStructures(scene.labels);
      scene.labels.unlabelled = 0;
      // Three segments of half a voxel have their middle in a voxel, or on its sides.
      EXPECT_NEAR(colorOf(draw(scene, kLabelsSize), kLeft).a, opacity, 0.55 * opacity + 0.5 / 255.0) << "voxel " << y;
    }
}

TEST_F(LabelsGL, LabelsOnAnotherGridLieByWorldPosition) {
  Image own = draw(halves(), kLabelsSize, kAllLayers);
  ASSERT_NE(sampleOf(own, {16, 32}, "id"), sampleOf(own, {48, 32}, "id"));
  const std::pair<glm::dmat4, glm::ivec3> kGrids[] = {
      {centredFrame({64, 16, 20}, {0.5, 2, 1.6}), {64, 16, 20}},
      {centredFrame({40, 40, 40}, {-1, 1, -1}), {40, 40, 40}},
      {centredFrame({80, 80, 80}, {1, 1, 1}, 0.4), {80, 80, 80}},
  };
  for (const auto& [frame, dims] : kGrids) {
    Image other = draw(halves(frame, dims), kLabelsSize, kAllLayers);
    for (int x = 0; x < kLabelsSize.x; ++x) {
      if (std::abs(x - 32) < 5) continue;  // voxels of the turned grid at the border
      EXPECT_EQ(sampleOf(other, {x, 32}, "id"), sampleOf(own, {x, 32}, "id")) << "column " << x;
    }
  }
}

TEST_F(LabelsGL, LieOnTheirDataWhereverThatLies) {
  Image centred = draw(halves(), kLabelsSize, kAllLayers);
  for (glm::dvec3 place : {glm::dvec3(300, -120, 75), glm::dvec3(-9, 4, 1e4)}) {
    Image image =
        draw(halves(centredFrame(kLabelsDims, glm::dvec3(1), 0, place), kLabelsDims, place), kLabelsSize, kAllLayers);
    for (int x = 0; x < kLabelsSize.x; ++x)
      EXPECT_EQ(sampleOf(image, {x, 32}, "id"), sampleOf(centred, {x, 32}, "id")) << "column " << x;
  }
}

TEST_F(LabelsGL, OutsideTheLabelsThereIsNoStructure) {
  scene::Scene scene = halves(centredFrame({8, 32, 32}), {8, 32, 32});
  Image image = draw(scene, kLabelsSize, kAllLayers);
  EXPECT_EQ(sampleOf(image, kLeft, "id"), 0.0f);
  EXPECT_EQ(sampleOf(image, {30, 32}, "id"), 1.0f);
  EXPECT_EQ(sampleOf(image, {34, 32}, "id"), 300.0f);
  EXPECT_GT(colorOf(image, kLeft).r, 0.99f);
}

TEST_F(LabelsGL, LabelsAloneShowTheirStructures) {
  for (bool shaded : {false, true}) {
    scene::Scene scene = halves();
    scene.volume.data = {};
    scene.lighting.shaded = shaded;
    scene.lighting.shadow = scene.lighting.occlusion = 0;
    Image image = draw(scene, kLabelsSize, kAllLayers);
    EXPECT_GT(colorOf(image, kLeft).a, 0.95f);
    EXPECT_GT(colorOf(image, kLeft).g, 5 * colorOf(image, kLeft).r);
    EXPECT_GT(colorOf(image, kRight).b, 5 * colorOf(image, kRight).r);
    EXPECT_EQ(sampleOf(image, kLeft, "id"), 1.0f);
    EXPECT_NEAR(vectorOf(image, kLeft, "position").y, -16, 1.2);
    scene.labels.structures[0].visible = false;
    image = draw(scene, kLabelsSize);
    EXPECT_EQ(colorOf(image, kLeft).a, 0.0f);
    EXPECT_GT(colorOf(image, kRight).a, 0.95f);
  }
}

TEST_F(LabelsGL, ASmallBallOfLabelsAloneIsABall) {
  scene::Scene scene = sceneOf(makeVolume(
      kLabelsDims, SampleType::UInt8, [](glm::ivec3) { return 0.0; }, centredFrame(kLabelsDims)));
  scene.labels.data = Shared<LabelVolume>(makeLabels(
      kLabelsDims, [](glm::ivec3 p) { return glm::length(glm::dvec3(p) - 15.5) < 9 ? 5 : 0; },
      centredFrame(kLabelsDims)));
  scene::completeStructures(scene.labels);
  scene.volume.data = {};
  scene.camera.projection = scene::Projection::Orthographic;
  scene.camera.height = 32;
  Image image = draw(scene, kLabelsSize, kAllLayers);
  int count = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) count += sampleOf(image, {x, y}, "A") > 0.5f;
  EXPECT_NEAR(count, M_PI * 18 * 18, 0.08 * M_PI * 18 * 18);
}

}  // namespace
}  // namespace velum
