// How far structures can stand out of cuts.
#include "session/extrusion/PulledEnd.h"

#include <gtest/gtest.h>

#include "GrowthScene.h"
#include "makeVolume.h"
#include "scene/timeline/SceneAt.h"
#include "session/extrusion/Extrusion.h"
#include "session/extrusion/Pull.h"
#include "session/film/ReadyFilms.h"
#include "session/growth/Growths.h"

namespace velum::session {
namespace {

constexpr int kPulledEndEdge = 48;
constexpr double kRadius = 14.0;
const glm::dvec3 kMiddle(23.5);

/// A ball about the middle, and a plane through it.
scene::Scene ballScene() {
  return growthScene(kPulledEndEdge, 1,
                     [](glm::ivec3 v, int) { return glm::distance(glm::dvec3(v), kMiddle) < kRadius ? 150 : 20; });
}

scene::Scene labelledScene() {
  scene::Scene scene = ballScene();
  scene.labels.data = Shared<LabelVolume>(makeLabels(glm::ivec3(kPulledEndEdge), [](glm::ivec3 v) {
    return glm::distance(glm::dvec3(v), kMiddle) < kRadius ? 4 : 0;
  }));
  scene.labels.structures = {{4, "ball"}};
  return scene;
}

TEST(PulledEnd, IsThatOfTheFarthestVoxel) {
  scene::Scene scene = labelledScene();
  for (glm::dvec3 axis : {glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 3), glm::dvec3(1, -2, 0.5)})
    for (double off : {-10.0, 0.0, 8.0}) {
      scene.cuts[0].axis = axis;
      scene.cuts[0].centre = kMiddle + off * glm::normalize(axis);
      EXPECT_NEAR(pulledEnd(scene, scene.cuts[0], 4), kRadius - off, 1.0);
    }
  scene.cuts[0].centre = kMiddle + 20.0 * glm::normalize(scene.cuts[0].axis);
  EXPECT_EQ(pulledEnd(scene, scene.cuts[0], 4), 0.0) << "nothing of it lies there";
}

TEST(PulledEnd, IsTheFarFaceOfTheLastVoxel) {
  scene::Scene scene = labelledScene();
  scene.cuts[0].axis = {0, -1, 0};
  scene.cuts[0].centre = kMiddle;
  // The first voxels of the ball along y have their middles at 10, their far faces at 9.5.
  EXPECT_NEAR(pulledEnd(scene, scene.cuts[0], 4), kMiddle.y - 9.5, 1e-9);
}

TEST(PulledEnd, IsThatOfTheDataWhereNobodyKnowsTheStructures) {
  scene::Scene scene = ballScene();
  EXPECT_NEAR(pulledEnd(scene, scene.cuts[0], 7), 0.5 * kPulledEndEdge + 0.5, 1e-6);
  scene = labelledScene();
  EXPECT_NEAR(pulledEnd(scene, scene.cuts[0], 0), 0.5 * kPulledEndEdge + 0.5, 1e-6) << "what has no label";
}

TEST(PulledEnd, OfWhatGrowsIsKnownWhenItHasCometoItsEnd) {
  scene::Scene scene = ballScene();
  auto pull = beginPull(scene, scene.cuts[0].id, kMiddle, 0);
  ASSERT_TRUE(pull);
  Progress progress;
  auto endAt = [&](double distance) {
    pullTo(scene, *pull, distance);
    settleGrowths(scene, progress);
    return pulledEnd(scene, scene.cuts[0], pull->structure);
  };
  double all = 0.5 * kPulledEndEdge + 0.5;
  EXPECT_NEAR(endAt(5.0), all, 1e-6) << "there may be more";
  EXPECT_NEAR(endAt(20.0), kRadius, 1.0);
}

TEST(PulledEnd, OutOfAnotherCutThereMayBeMore) {
  scene::Scene scene = ballScene();
  scene::Cut other = scene.cuts[0];
  other.axis = {0, 0, 1};
  int id = scene::addCut(scene, other);
  auto pull = beginPull(scene, scene.cuts[0].id, kMiddle, 0);
  ASSERT_TRUE(pull);
  Progress progress;
  pullTo(scene, *pull, 20.0);
  settleGrowths(scene, progress);
  EXPECT_NEAR(pulledEnd(scene, scene.cuts[0], pull->structure), kRadius, 1.0);
  EXPECT_NEAR(pulledEnd(scene, *scene::findCut(scene, id), pull->structure), 0.5 * kPulledEndEdge, 1.0)
      << "what the first one keeps has not been looked for";
}

TEST(PulledEnd, OutOfAMembraneIsThatOfTheDataUntilAllIsFound) {
  scene::Scene scene = ballScene();
  scene.cuts[0].shape = scene::CutShape::Membrane;
  scene.cuts[0].membrane.emplace();
  scene.cuts[0].size = {kPulledEndEdge, kPulledEndEdge, 12.0};
  auto pull = beginPull(scene, scene.cuts[0].id, kMiddle, 0);
  ASSERT_TRUE(pull);
  Progress progress;
  auto endAt = [&](double distance) {
    pullTo(scene, *pull, distance);
    settleGrowths(scene, progress);
    return pulledEnd(scene, scene.cuts[0], pull->structure);
  };
  EXPECT_GT(endAt(3.0), kRadius + 2.0) << "there may be more";
  EXPECT_NEAR(endAt(22.0), kRadius, 1.0);
}

TEST(PulledEnd, AFilmDoesNotStandStillBeyondIt) {
  scene::Scene scene = labelledScene();
  setExtrusion(scene.cuts[0], 4, 400.0);
  double end = pulledEnd(scene, scene.cuts[0], 4);
  for (int i = 1; i < 10; ++i) {
    scene::Scene film = scene;
    addPulling(film, {0.0, 1.0}, 0.0, 0.0);
    double last = 1.0 - 1.0 / film.timeline.framesPerSecond;
    scene::Scene now = scene::sceneAt(film, 0.1 * i * last);
    ASSERT_EQ(extrusionsOf(now).size(), 1u);
    double t = 0.1 * i;
    EXPECT_NEAR(extrusionsOf(now)[0].distance, end * t * t * (3.0 - 2.0 * t), 1e-9);
  }
}

}  // namespace
}  // namespace velum::session
