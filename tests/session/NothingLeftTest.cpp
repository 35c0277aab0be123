#include "session/cut/NothingLeft.h"

#include <gtest/gtest.h>

#include "makeModel.h"
#include "makeVolume.h"
#include "scene/Scene.h"

namespace velum::session {
namespace {

constexpr glm::ivec3 kNothingLeftDims(60, 60, 60);

/// A ball of 40 voxels across, of value 100, in the middle of a box of zeros, whose middle is 0, 0, 0.
scene::Scene ballScene() {
  scene::Scene scene;
  auto valueOf = [](glm::ivec3 p) { return glm::length(glm::dvec3(p) - 29.5) < 20 ? 100.0 : 0.0; };
  scene.volume.data =
      Shared<Volume>(makeVolume(kNothingLeftDims, SampleType::UInt8, valueOf, centredFrame(kNothingLeftDims)));
  scene.volume.transfer.opacities = {{0, 0}, {50, 0}, {100, 0.5}};
  return scene;
}

scene::Scene with(scene::Scene scene, const scene::Cut& cut) {
  scene::addCut(scene, cut);
  return scene;
}

/// Takes what lies above.
scene::Cut plane(double z) {
  scene::Cut cut;
  cut.centre = {0, 0, z};
  cut.axis = {0, 0, 1};
  return cut;
}

bool takesAll(const scene::Scene& scene) {
  Progress progress;
  return cutsTakeAll(scene, progress);
}

TEST(NothingLeft, APlaneTakesAllBeyondWhatShows) {
  EXPECT_FALSE(takesAll(ballScene()));
  EXPECT_FALSE(takesAll(with(ballScene(), plane(0))));
  EXPECT_FALSE(takesAll(with(ballScene(), plane(-19)))) << "a cap of a voxel is left";
  EXPECT_TRUE(takesAll(with(ballScene(), plane(-25)))) << "air is left";
  EXPECT_TRUE(takesAll(with(ballScene(), plane(-200))));
  scene::Cut off = plane(-200);
  off.enabled = false;
  EXPECT_FALSE(takesAll(with(ballScene(), off)));
}

TEST(NothingLeft, AllCutsTogetherMayTakeAll) {
  scene::Cut other = plane(0);
  other.axis = {0, 0, -1};
  EXPECT_FALSE(takesAll(with(ballScene(), other)));
  EXPECT_FALSE(takesAll(with(with(ballScene(), plane(1)), other))) << "a layer of voxels is left";
  other.centre.z = 1.5;
  EXPECT_TRUE(takesAll(with(with(ballScene(), plane(1)), other)));
}

TEST(NothingLeft, OneVoxelIsSomething) {
  scene::Scene scene = ballScene();
  scene::Cut sphere = plane(8.5);
  sphere.shape = scene::CutShape::Sphere;
  sphere.centre = {3.5, -6.5, 8.5};
  sphere.size = glm::dvec3(1.0);
  sphere.invert = true;
  EXPECT_FALSE(takesAll(with(scene, sphere)));
  sphere.centre.x = 200;
  EXPECT_TRUE(takesAll(with(scene, sphere)));
}

TEST(NothingLeft, ASectionOnAFaceIsSomething) {
  scene::Cut cut = plane(-25);
  cut.face = scene::CutFace::Section;
  EXPECT_FALSE(takesAll(with(ballScene(), cut)));
  cut.centre.z = -200;
  EXPECT_TRUE(takesAll(with(ballScene(), cut)));
}

TEST(NothingLeft, WhatIsSparedIsSomething) {
  scene::Scene scene = ballScene();
  auto idOf = [](glm::ivec3 p) { return glm::length(glm::dvec3(p) - 29.5) < 4 ? 3 : 0; };
  scene.labels.data = Shared<LabelVolume>(makeLabels(kNothingLeftDims, idOf, centredFrame(kNothingLeftDims)));
  scene::completeStructures(scene.labels);
  scene::Cut cut = plane(-200);
  EXPECT_TRUE(takesAll(with(scene, cut)));
  cut.spares = {{3}};
  EXPECT_FALSE(takesAll(with(scene, cut)));
  scene.labels.structures.back().visible = false;
  EXPECT_TRUE(takesAll(with(scene, cut))) << "it is hidden";
}

TEST(NothingLeft, WhereNothingShowsNoCutIsToBlame) {
  scene::Scene scene = ballScene();
  scene.volume.transfer.opacities = {{0, 0}};
  EXPECT_FALSE(takesAll(with(scene, plane(-200))));
  scene = {};
  EXPECT_FALSE(takesAll(with(scene, plane(-200))));
}

TEST(NothingLeft, InstancesAndLabelsAloneCount) {
  scene::Scene scene;
  scene.model.data = Shared<Model>(ModelMaker{.types = 3, .instances = 60, .halfEdge = 80.0f}.make());
  EXPECT_FALSE(takesAll(with(scene, plane(0))));
  EXPECT_TRUE(takesAll(with(scene, plane(-2000))));
  scene::Cut sparing = plane(-2000);
  sparing.model.spares = {{"root", 0.5}};
  EXPECT_FALSE(takesAll(with(scene, sparing)));
  scene::Scene labels;
  labels.labels.data = Shared<LabelVolume>(makeLabels(
      kNothingLeftDims, [](glm::ivec3 p) { return p.x < 5 ? 1 : 0; }, centredFrame(kNothingLeftDims)));
  scene::completeStructures(labels.labels);
  EXPECT_FALSE(takesAll(with(labels, plane(0))));
  EXPECT_TRUE(takesAll(with(labels, plane(-200))));
}

}  // namespace
}  // namespace velum::session
