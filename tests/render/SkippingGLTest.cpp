// Leaping over empty space and ending rays early change the cost of a picture, never the picture.
#include <functional>

#include "RenderFixture.h"

namespace velum {
namespace {

constexpr glm::ivec3 kSkippingDims(45, 38, 51);  // no multiple of the cells' edge

class SkippingGL : public RenderTest {
 protected:
  /// @param shown  share of the picture that must show something, so that equal pictures mean something
  void expectSameAsBruteForce(scene::Scene scene, std::string_view what, double shown = 0.01) {
    const glm::dvec3 kSides[] = {{0.45, -1, 0.3}, {0, -1, 0}, {0, 0, 1}};
    for (glm::dvec3 side : kSides)
      for (bool jitter : {true, false}) {
        lookAlong(scene, side, 120);
        scene.camera.fieldOfViewDeg = 32;
        scene.rayCast.jitter = jitter;
        scene.rayCast.skipEmpty = scene.rayCast.stopOpaque = true;
        Image fast = draw(scene, {80, 80});
        scene.rayCast.skipEmpty = scene.rayCast.stopOpaque = false;
        Image slow = draw(scene, {80, 80});
        expectSame(fast, slow, 1.0,
                   std::string(what) + " from " + std::to_string(side.x) + " " + std::to_string(side.y) + " " +
                       std::to_string(side.z));
        EXPECT_GT(coverageOf(slow), shown) << what;
      }
  }
  static scene::Scene sceneWith(std::function<double(glm::ivec3)> valueOf, SampleType type = SampleType::UInt8) {
    scene::Scene scene = sceneOf(makeVolume(kSkippingDims, type, valueOf, centredFrame(kSkippingDims)));
    scene.volume.transfer.colors = {{0, {0.2f, 0.4f, 1}}, {255, {1, 0.7f, 0.3f}}};
    scene.volume.transfer.opacities = {{40, 0}, {200, 0.9}};
    return scene;
  }
};

TEST_F(SkippingGL, SheetsLinesAndPointsOneVoxelThin) {
  expectSameAsBruteForce(sceneWith([](glm::ivec3 p) { return p.y == 17 ? 220.0 : 0.0; }), "a sheet");
  expectSameAsBruteForce(sceneWith([](glm::ivec3 p) { return p.x + p.y == 40 ? 255.0 : 0.0; }), "a slanted sheet");
  expectSameAsBruteForce(sceneWith([](glm::ivec3 p) { return p.x % 11 == 3 && p.z % 13 == 8 ? 255.0 : 0.0; }), "lines");
  expectSameAsBruteForce(
      sceneWith([](glm::ivec3 p) { return p.x % 8 == 7 && p.y % 8 == 0 && p.z % 8 == 3 ? 255.0 : 0.0; }), "points");
  expectSameAsBruteForce(sceneWith([](glm::ivec3 p) { return p.x == 0 || p.z == kSkippingDims.z - 1 ? 255.0 : 0.0; }),
                         "sheets on the border");
}

TEST_F(SkippingGL, Noise) {
  expectSameAsBruteForce(sceneWith([](glm::ivec3 p) { return 255.0 * hashNoise(p); }), "dense noise");
  expectSameAsBruteForce(sceneWith([](glm::ivec3 p) { return hashNoise(p) > 0.995 ? 255.0 : 10 * hashNoise(p, 2); }),
                         "sparse noise");
  expectSameAsBruteForce(sceneWith([](glm::ivec3 p) { return 3000 * hashNoise(p) - 1000; }, SampleType::Float32),
                         "noise of floats");
}

TEST_F(SkippingGL, ASteepPeakBetweenTwoValues) {
  // No voxel has a value inside the peak; between the two halves the values run through it.
  scene::Scene scene = sceneWith([](glm::ivec3 p) { return p.y + (p.x > 20 ? 6 : 0) < 22 ? 20.0 : 230.0; });
  scene.volume.transfer.opacities = {{118, 0}, {120, 0.95}, {122, 0}};
  expectSameAsBruteForce(scene, "a peak between values", 0.005);
  scene.volume.transfer.opacities = {{20, 0.8}, {20.5, 0}, {229.5, 0}, {230, 0.02}};
  expectSameAsBruteForce(scene, "peaks at the values");
}

TEST_F(SkippingGL, OpacityByGradient) {
  scene::Scene scene = sceneWith([](glm::ivec3 p) { return glm::length(glm::dvec3(p) - 22.0) < 15 ? 180.0 : 60.0; });
  scene.volume.transfer.opacities = {{0, 0.6}, {255, 0.6}};
  scene.volume.transfer.gradientOpacities = {{5, 0}, {40, 1}};
  expectSameAsBruteForce(scene, "gradient opacity");
}

TEST_F(SkippingGL, Shaded) {
  scene::Scene scene = sceneWith([](glm::ivec3 p) {
    return glm::length(glm::dvec3(p) - glm::dvec3(22, 18, 25)) < 13 ? 220.0 : p.z == 5 ? 190.0 : 0.0;
  });
  scene.lighting.shaded = true;
  expectSameAsBruteForce(scene, "shaded");
}

TEST_F(SkippingGL, LabelsWithHiddenOnes) {
  scene::Scene scene = sceneWith([](glm::ivec3 p) { return 100 + 100 * hashNoise(p); });
  LabelVolume labels = makeLabels(
      kSkippingDims, [](glm::ivec3 p) { return p.x / 9 + 8 * (p.z / 11); }, scene.volume.data->worldFromVoxel);
  scene.labels.data = Shared<LabelVolume>(std::move(labels));
  scene::completeStructures(scene.labels);
  for (auto& structure : scene.labels.structures) structure.visible = structure.id % 3 == 0;
  scene.labels.unlabelled = 0.0;
  expectSameAsBruteForce(scene, "hidden structures");
  scene.labels.unlabelled = 0.3;
  for (auto& structure : scene.labels.structures) structure.opacity = structure.id % 2 ? 0.0 : 0.4;
  expectSameAsBruteForce(scene, "faint structures");
  // Ids 64 apart share a bit of the cells' sets.
  LabelVolume shared = makeLabels(
      kSkippingDims, [](glm::ivec3 p) { return p.y < 19 ? 1 : 65; }, scene.volume.data->worldFromVoxel);
  scene.labels = {};
  scene.labels.data = Shared<LabelVolume>(std::move(shared));
  scene::completeStructures(scene.labels);
  scene.labels.structures[0].visible = false;
  expectSameAsBruteForce(scene, "ids that share a bit");
}

TEST_F(SkippingGL, LabelsAlone) {
  scene::Scene scene = sceneWith([](glm::ivec3) { return 0.0; });
  LabelVolume labels = makeLabels(
      kSkippingDims, [](glm::ivec3 p) { return glm::length(glm::dvec3(p) - 20.0) < 11 ? 3
                                               : p.z == 40                            ? 7
                                                                                      : 0; },
      scene.volume.data->worldFromVoxel);
  scene.labels.data = Shared<LabelVolume>(std::move(labels));
  scene.volume.data = {};
  scene::completeStructures(scene.labels);
  expectSameAsBruteForce(scene, "labels alone");
}

TEST_F(SkippingGL, CutsThatSpare) {
  scene::Scene scene = sceneWith([](glm::ivec3 p) { return p.y > 6 && p.y < 30 ? 120 + 80 * hashNoise(p) : 0.0; });
  LabelVolume labels = makeLabels(
      kSkippingDims,
      [](glm::ivec3 p) { return glm::length(glm::dvec3(p) - glm::dvec3(20, 12, 25)) < 8 ? 5
                                : p.x == 30                                             ? 6
                                                                                        : 0; },
      scene.volume.data->worldFromVoxel);
  scene.labels.data = Shared<LabelVolume>(std::move(labels));
  scene::completeStructures(scene.labels);
  scene::Cut plane, ball;
  plane.axis = {0.2, -1, 0.1};
  plane.spares = {{5}};
  ball.shape = scene::CutShape::Sphere;
  ball.centre = {8, 0, 5};
  ball.size = glm::dvec3(22);
  ball.spares = {{6}};
  scene.cuts = {plane, ball};
  expectSameAsBruteForce(scene, "cuts that spare");
  scene.cuts[1].spares = {{5}, {6}};
  scene.cuts[1].invert = true;
  expectSameAsBruteForce(scene, "an inverted cut that spares");
  scene.cuts[0].face = scene::CutFace::Section;
  expectSameAsBruteForce(scene, "a section face");
}

/// Cells beyond the ends of all that cuts spare in them are leapt over; 6 and 70 share a bit of the cells' sets.
TEST_F(SkippingGL, WhatIsSparedUpToADepth) {
  scene::Scene scene = sceneWith([](glm::ivec3 p) { return p.y > 3 && p.y < 34 ? 120 + 80 * hashNoise(p) : 0.0; });
  LabelVolume labels = makeLabels(
      kSkippingDims,
      [](glm::ivec3 p) {
        return glm::length(glm::dvec2(p.x, p.z) - glm::dvec2(14, 25)) < 8 ? 6 : p.x > 26 && p.x < 36 ? 70 : 0;
      },
      scene.volume.data->worldFromVoxel);
  scene.labels.data = Shared<LabelVolume>(std::move(labels));
  scene::completeStructures(scene.labels);
  scene::Cut plane, second;
  plane.axis = {0.2, -1, 0.1};
  plane.centre = {0, 9, 0};
  plane.spares = {{6, 21.5}, {70, 4.2}};
  scene.cuts = {plane};
  for (double tint : {0.0, 1.0}) {
    scene.labels.tint = tint;
    expectSameAsBruteForce(scene, "one plane");
  }
  second.axis = {-1, -0.1, 0.3};
  second.joined = true;
  second.spares = {{6, 2.5}, {70, 11.0}};
  scene.cuts = {plane, second};
  for (auto mode : {scene::RenderMode::Volume, scene::RenderMode::Iso}) {
    scene.rayCast.mode = mode;
    scene.rayCast.isoValue = 150;
    expectSameAsBruteForce(scene, "two planes");
  }
  scene.rayCast.mode = scene::RenderMode::Volume;
  scene.cuts[1].joined = false;
  scene.cuts[1].shape = scene::CutShape::Sphere;
  scene.cuts[1].size = glm::dvec3(30);
  expectSameAsBruteForce(scene, "a plane and a ball");
}

TEST_F(SkippingGL, MaximumAndIsosurface) {
  for (auto mode : {scene::RenderMode::Mip, scene::RenderMode::Iso}) {
    scene::Scene noise = sceneWith([](glm::ivec3 p) { return 250 * hashNoise(p) * hashNoise(p, 2); });
    scene::Scene thin = sceneWith([](glm::ivec3 p) { return p.x == 13 || (p.y == 20 && p.z == 31) ? 240.0 : 5.0; });
    for (scene::Scene* scene : {&noise, &thin}) {
      scene->rayCast.mode = mode;
      scene->rayCast.isoValue = 120;
      std::string what = mode == scene::RenderMode::Mip ? "maximum" : "isosurface";
      expectSameAsBruteForce(*scene, what);
      scene::Cut plane;
      plane.axis = {0.5, -1, 0.3};
      scene->cuts = {plane};
      expectSameAsBruteForce(*scene, what + " behind a cut");
    }
  }
}

TEST_F(SkippingGL, AnIsosurfaceAtTheGreatestValue) {
  scene::Scene box = sceneWith([](glm::ivec3 p) {
    return glm::all(glm::greaterThan(p, glm::ivec3(9))) && glm::all(glm::lessThan(p, glm::ivec3(30))) ? 255.0 : 17.0;
  });
  box.rayCast.mode = scene::RenderMode::Iso;
  box.rayCast.isoValue = 255.0;
  expectSameAsBruteForce(box, "a box", 0.04);
}

TEST_F(SkippingGL, SectionsOfVoxels) {
  // One voxel thick along one axis, as a single section.
  for (int axis = 0; axis < 3; ++axis) {
    glm::ivec3 dims(40);
    dims[axis] = 1;
    scene::Scene scene = sceneOf(makeVolume(
        dims, SampleType::UInt8, [](glm::ivec3 p) { return 255 * hashNoise(p); }, centredFrame(dims)));
    scene.volume.transfer.opacities = {{100, 0}, {200, 0.9}};
    expectSameAsBruteForce(scene, "a section", 0.0);
  }
}

}  // namespace
}  // namespace velum
