#include "scene/Scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "makeVolume.h"
#include "scene/Shown.h"

namespace velum::scene {
namespace {

Scene sceneOf(const glm::dmat4& worldFromVoxel, glm::ivec3 dims = {20, 30, 50}) {
  Scene scene;
  scene.volume.data = Shared<Volume>(makeVolume(
      dims, SampleType::UInt8, [](glm::ivec3) { return 1.0; }, worldFromVoxel));
  return scene;
}

/// Largest |x| and |y| of the volume's corners in the picture, 1 at its edge.
double furthestCorner(const Scene& scene, double aspect) {
  const Camera& c = scene.camera;
  glm::dvec3 forward = glm::normalize(c.target - c.eye);
  glm::dvec3 right = glm::normalize(glm::cross(forward, c.up));
  glm::dvec3 up = glm::cross(right, forward);
  double furthest = 0;
  for (int corner = 0; corner < 8; ++corner) {
    glm::dvec3 voxel;
    for (int axis = 0; axis < 3; ++axis) voxel[axis] = corner >> axis & 1 ? scene.volume.data->dims[axis] - 0.5 : -0.5;
    glm::dvec3 p = glm::dvec3(scene.volume.data->worldFromVoxel * glm::dvec4(voxel, 1.0)) - c.eye;
    double half = c.projection == Projection::Orthographic
                      ? c.height * 0.5
                      : glm::dot(p, forward) * std::tan(glm::radians(c.fieldOfViewDeg) * 0.5);
    if (half <= 0) return 1e9;  // behind the eye
    furthest = std::max({furthest, std::abs(glm::dot(p, right)) / (half * aspect), std::abs(glm::dot(p, up)) / half});
  }
  return furthest;
}

TEST(FrameCamera, SeesTheWholeBoxFromEverySide) {
  const glm::dmat4 kFrames[] = {centredFrame({20, 30, 50}, {1, 1, 1}),
                                centredFrame({20, 30, 50}, {0.3, 2, 5}, 0.7, {1000, -50, 3}),
                                centredFrame({20, 30, 50}, {1, -1, 1e-3})};
  for (const auto& frame : kFrames)
    for (double aspect : {0.4, 1.0, 16.0 / 9.0})
      for (double field : {5.0, 30.0, 120.0})
        for (Projection projection : {Projection::Perspective, Projection::Orthographic})
          for (int view = 0; view < 7; ++view) {
            Scene scene = sceneOf(frame);
            scene.camera.projection = projection;
            scene.camera.fieldOfViewDeg = field;
            scene.camera = frameCamera(scene, StandardView(view), aspect);
            double furthest = furthestCorner(scene, aspect);
            std::string what = std::string(enumName(StandardView(view))) + ", field " + std::to_string(field) +
                               ", aspect " + std::to_string(aspect);
            EXPECT_LE(furthest, 1.0) << what;
            EXPECT_GT(furthest, 0.2) << what << ": the scene is a dot";
            EXPECT_EQ(scene.camera.projection, projection);
            EXPECT_EQ(scene.camera.fieldOfViewDeg, field);
          }
}

TEST(FrameCamera, LooksFromTheSideThatItsNameSays) {
  Scene scene = sceneOf(centredFrame({20, 30, 50}, {1, 1, 1}));
  auto toEye = [&](StandardView view) {
    Camera camera = frameCamera(scene, view, 1.0);
    return glm::normalize(camera.eye - camera.target);
  };
  // LPS: x to the patient's left, y to the back, z to the head.
  EXPECT_GT(toEye(StandardView::Anterior).y, -1.001);
  EXPECT_LT(toEye(StandardView::Anterior).y, -0.999);
  EXPECT_GT(toEye(StandardView::Posterior).y, 0.999);
  EXPECT_GT(toEye(StandardView::Left).x, 0.999);
  EXPECT_LT(toEye(StandardView::Right).x, -0.999);
  EXPECT_GT(toEye(StandardView::Superior).z, 0.999);
  EXPECT_LT(toEye(StandardView::Inferior).z, -0.999);
}

TEST(DefaultView, AThinSlabIsSeenFromItsWideSide) {
  auto viewOf = [](glm::ivec3 dims, bool isPatient) {
    Scene scene;
    Volume volume = makeVolume(dims, SampleType::UInt8, [](glm::ivec3 v) { return v.x; });
    volume.isOrientationKnown = isPatient;
    scene.volume.data = Shared<Volume>(std::move(volume));
    return defaultView(scene);
  };
  for (bool isPatient : {false, true}) {
    EXPECT_EQ(viewOf({40, 40, 4}, isPatient), StandardView::Superior);
    EXPECT_EQ(viewOf({4, 40, 40}, isPatient), StandardView::Left);
    EXPECT_EQ(viewOf({40, 4, 40}, isPatient), StandardView::Anterior);
  }
  EXPECT_EQ(viewOf({20, 40, 30}, true), StandardView::Anterior) << "people are met face to face";
  EXPECT_EQ(viewOf({20, 40, 30}, false), StandardView::Oblique);
}

/// An angiography is a slab about the skull's base: from the front there would be a strip of it.
TEST(DefaultView, ASlabOfAnMrIsSeenAsItWasTaken) {
  for (auto [modality, view] : {std::pair(Modality::MR, StandardView::Superior),
                                {Modality::Angiography, StandardView::Superior},
                                {Modality::CT, StandardView::Anterior}}) {
    Scene scene;
    Volume volume = makeVolume({40, 44, 14}, SampleType::Int16, [](glm::ivec3 v) { return v.x; });
    volume.modality = modality;
    scene.volume.data = Shared<Volume>(std::move(volume));
    EXPECT_EQ(defaultView(scene), view) << enumName(modality);
  }
}

TEST(FrameCamera, AnEmptySceneGivesAUsableCamera) {
  Camera camera = frameCamera(Scene{}, StandardView::Oblique, 1.5);
  EXPECT_GT(glm::length(camera.eye - camera.target), 0.0);
  EXPECT_TRUE(std::isfinite(camera.eye.x) && camera.height > 0);
}

TEST(Shown, FieldsOutOfRangeShowTheNearestThatThereIs) {
  Scene scene = sceneOf(glm::dmat4(1.0));
  scene.volume.timeStep = 7, scene.volume.channel = -2, scene.model.copies = 0;
  EXPECT_EQ(shownTimeStep(scene.volume), 0);
  EXPECT_EQ(shownChannel(scene.volume), 0);
  EXPECT_EQ(copyCount(scene.model), 1);
  scene.cuts.resize(3);
  scene.cuts[1].enabled = false;
  std::vector<const Cut*> on;
  for (const Cut& cut : enabledOf(scene.cuts)) on.push_back(&cut);
  EXPECT_EQ(on, (std::vector<const Cut*>{&scene.cuts[0], &scene.cuts[2]}));
}

TEST(WorldFromCut, IsRigidAndStandsOnItsAxis) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-5, 5), turn(-360, 360);
  for (int i = 0; i < 300; ++i) {
    Cut cut;
    cut.axis = i < 6 ? glm::dvec3((i % 3 == 0) * (i < 3 ? 1 : -1), (i % 3 == 1) * (i < 3 ? 1 : -1),
                                  (i % 3 == 2) * (i < 3 ? 1 : -1))
                     : glm::dvec3(any(random), any(random), any(random));
    cut.spinDeg = turn(random);
    cut.centre = {any(random) * 100, any(random), any(random)};
    glm::dmat4 m = worldFromCut(cut);
    glm::dmat3 r(m);
    glm::dmat3 unit = glm::transpose(r) * r;
    for (int c = 0; c < 3; ++c)
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(unit[c][k], c == k ? 1.0 : 0.0, 1e-12);
    EXPECT_NEAR(glm::determinant(r), 1.0, 1e-12);
    EXPECT_LT(glm::length(r[2] - glm::normalize(cut.axis)), 1e-12);
    EXPECT_EQ(glm::dvec3(m[3]), cut.centre);
  }
}

TEST(WorldFromCut, AnAxisWithoutLengthIsStillRigid) {
  for (glm::dvec3 axis : {glm::dvec3(0.0), glm::dvec3(1e-300, 0, 0)}) {
    Cut cut;
    cut.axis = axis;
    EXPECT_NEAR(glm::determinant(worldFromCut(cut)), 1.0, 1e-12);
  }
}

TEST(WorldFromCut, SpinTurnsABoxAboutItsAxis) {
  Cut cut;
  cut.axis = {0, 0, 1};
  glm::dmat4 before = worldFromCut(cut);
  cut.spinDeg = 90;
  glm::dmat4 after = worldFromCut(cut);
  EXPECT_LT(glm::length(after[0] - before[1]), 1e-12);
  EXPECT_LT(glm::length(after[2] - before[2]), 1e-12);
}

TEST(CompleteStructures, KeepsWhatTheSceneSaysAndAddsTheRest) {
  LabelVolume data({4, 4, 4}, glm::dmat4(1.0));
  data.table = {{2, "liver", {1, 0, 0}, 1.0f}, {9, "spleen", {0, 1, 0}, 0.5f}};
  LabelLayer layer;
  layer.data = Shared<LabelVolume>(data);
  layer.structures = {{9, "my name", {0, 0, 1}, 0.25, false}};
  completeStructures(layer);
  ASSERT_EQ(layer.structures.size(), 2u);
  EXPECT_EQ(layer.structures[0], (Structure{2, "liver", {1, 0, 0}, 1.0, true}));
  EXPECT_EQ(layer.structures[1], (Structure{9, "my name", {0, 0, 1}, 0.25, false}));
}

TEST(CompleteStructures, AddsAnIdOnce) {
  LabelVolume data({4, 4, 4}, glm::dmat4(1.0));
  data.table = {{7, "first", {1, 0, 0}, 1.0f}, {7, "second", {0, 1, 0}, 0.5f}, {2, "liver", {1, 0, 0}, 1.0f}};
  LabelLayer layer;
  layer.data = Shared<LabelVolume>(data);
  for (int turn = 0; turn < 2; ++turn) {
    completeStructures(layer);
    ASSERT_EQ(layer.structures.size(), 2u);
    EXPECT_EQ(layer.structures[0].name, "liver");
    EXPECT_EQ(layer.structures[1].name, "first");
  }
}

TEST(EffectiveWindow, IsTheWholeRangeUntilOneIsSet) {
  Scene scene;
  scene.volume.data =
      Shared<Volume>(makeVolume({4, 4, 4}, SampleType::Int16, [](glm::ivec3 v) { return v.x * 100.0 - 100.0; }));
  EXPECT_EQ(effectiveWindow(scene.volume), glm::dvec2(50, 300));
  scene.volume.windowLevel = 7;
  scene.volume.windowWidth = 20;
  EXPECT_EQ(effectiveWindow(scene.volume), glm::dvec2(7, 20));
}

TEST(PictureScene, AWindowCountsOnlyWhereThePictureShowsGreyValues) {
  Scene scene, other;
  setWindow(other.volume, 40, 400);
  other.volume.channels = scene.volume.channels = {{"a"}, {"b"}};
  other.volume.channels[1].windowWidth = 7;
  EXPECT_EQ(pictureScene(scene), pictureScene(other));
  scene.rayCast.mode = other.rayCast.mode = RenderMode::Mip;
  EXPECT_NE(pictureScene(scene), pictureScene(other));
  scene.rayCast.mode = other.rayCast.mode = RenderMode::Volume;
  Cut cut;
  cut.face = CutFace::Section;
  scene.cuts = other.cuts = {cut};
  EXPECT_NE(pictureScene(scene), pictureScene(other));
  scene.cuts[0].enabled = other.cuts[0].enabled = false;
  EXPECT_EQ(pictureScene(scene), pictureScene(other));
}

}  // namespace
}  // namespace velum::scene
