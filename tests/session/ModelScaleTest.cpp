// Numbers that hands set, and models beside data of another scale.
#include "session/model/ModelScale.h"

#include <gtest/gtest.h>

#include "makeModel.h"
#include "makeVolume.h"
#include "scene/Scene.h"
#include "session/model/ModelEdit.h"

namespace velum::session {

namespace {

scene::Scene sceneOfTypes() {
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(ModelMaker{.types = 5}.make());
  return scene;
}

}  // namespace

TEST(HeldNumbers, OneNumberOfATypeIsHeldTheLastThatWasSet) {
  scene::Scene scene = sceneOfTypes();
  EXPECT_FALSE(visibleTarget(scene, "root.a"));
  setVisibleTarget(scene, "root.a", 40.0);
  setVisibleTarget(scene, "root.b", 7.0);
  setVisibleTarget(scene, "root.a", 50.0);
  EXPECT_EQ(visibleTarget(scene, "root.a"), 50.0);
  EXPECT_EQ(scene.model.targets.size(), 2u);
  holdDrawn(scene, "root.a", 90.0);
  EXPECT_FALSE(visibleTarget(scene, "root.a")) << "so many are drawn, however many are seen";
  ASSERT_TRUE(isHeld(scene.model, "root.a"));
  EXPECT_EQ(targetOf(scene.model, "root.a")->rendered, 90.0);
  setVisibleTarget(scene, "root.a", 3.0);
  EXPECT_FALSE(targetOf(scene.model, "root.a")->rendered);
  setVisibleTarget(scene, "root.a", std::nullopt);
  EXPECT_FALSE(isHeld(scene.model, "root.a"));
  EXPECT_EQ(scene.model.targets.size(), 1u);
}

TEST(HeldNumbers, ANumberWithinACompartmentEndsTheCompartmentsOwnOfDrawnOnes) {
  scene::Scene scene = sceneOfTypes();
  holdDrawn(scene, "root", 100.0);
  setVisibleTarget(scene, "root.a", 30.0);
  EXPECT_FALSE(isHeld(scene.model, "root")) << "another number is drawn of it now";
  holdDrawn(scene, "root.a.type0", 5.0);
  EXPECT_EQ(visibleTarget(scene, "root.a"), 30.0) << "which can still be met";
  holdDrawn(scene, "root.ab", 6.0);
  EXPECT_EQ(heldWithin(scene, "root"), (std::vector<std::string>{"root.a", "root.ab"}));
  EXPECT_EQ(heldWithin(scene, "root.a"), (std::vector<std::string>{"root.a.type0"}));
  dropTargets(scene, "root.a");
  EXPECT_EQ(scene.model.targets.size(), 1u);
  EXPECT_TRUE(isHeld(scene.model, "root.ab")) << "a name that begins alike";
}

TEST(ModelScale, AModelThatIsOutOfScaleIsToldAndBroughtBesideTheOtherData) {
  scene::Scene scene = sceneOfTypes();
  EXPECT_EQ(othersByModel(scene), 1.0);
  EXPECT_EQ(scaleWords(scene), "");
  scene.unit = LengthUnit::Millimetre;
  auto valueOf = [](glm::ivec3 voxel) { return voxel.x; };
  glm::dmat4 head = glm::scale(glm::dmat4(1.0), glm::dvec3(18.0));  // 180 mm
  scene.volume.data = Shared<Volume>(makeVolume(glm::ivec3(10), SampleType::UInt8, valueOf, head));
  EXPECT_TRUE(isOutOfScale(scene));
  EXPECT_NE(scaleWords(scene).find("smaller"), std::string::npos) << scaleWords(scene);
  scene.camera.eye = {0.0, -500.0, 0.0}, scene.camera.target = glm::dvec3(0.0), scene.camera.up = {0.0, 0.0, 1.0};
  bringModelToSize(scene);
  EXPECT_FALSE(isOutOfScale(scene));
  EXPECT_NEAR(othersByModel(scene), 3.0, 1e-9);
  scene::ModelBox box = scene::worldBoxOfModel(scene);
  scene::Bounds all = scene::computeBounds(scene);
  EXPECT_GT(box.low.x, 171.0) << "to the right of the last voxel's edge, 9 mm beyond its middle";
  EXPECT_NEAR(all.max.x, box.high.x, 1e-6);
  EXPECT_NEAR(0.5 * (box.low.z + box.high.z), 81.0, 1e-6);
  std::optional<InstancePlace> place = instancePlace(scene, 0);
  ASSERT_TRUE(place);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_GE(place->middle[axis] - place->radius, box.low[axis] - 1e-6);
    EXPECT_LE(place->middle[axis] + place->radius, box.high[axis] + 1e-6);
  }
  bringModelToSize(scene);
  EXPECT_NEAR(othersByModel(scene), 3.0, 1e-9) << "it is there";
}

}  // namespace velum::session
