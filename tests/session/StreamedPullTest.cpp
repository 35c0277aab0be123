// Structures that are pulled out of volumes larger than memory: found, grown and undone in the voxels of the finest
// level.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "GrowthScene.h"
#include "PyramidSource.h"
#include "core/FinestVoxels.h"
#include "session/Session.h"
#include "session/extrusion/GrowStructure.h"
#include "session/extrusion/MaterialRange.h"
#include "session/extrusion/Pull.h"
#include "session/growth/Growths.h"
#include "session/structure/StructureSizes.h"
#include "session/structure/StructureValues.h"

namespace velum::session {

namespace {

constexpr int kBarsEdge = 64;

/// Bars along y, a voxel thin and every fourth, joined at y = 5: the coarse level shows nothing of them.
scene::Scene barsScene() {
  return growthScene(kBarsEdge, 1,
                     [](glm::ivec3 v, int) { return v.y == 5 || (v.x % 4 == 0 && v.z % 4 == 0) ? 150 : 20; });
}

std::shared_ptr<PyramidSource> stream(scene::Scene& scene) {
  auto source = std::make_shared<PyramidSource>(*scene.volume.data, 3, glm::ivec3(16));
  scene.volume.data = Shared<Volume>(streamedVolume(source, 2));
  return source;
}

void settlePulled(Session& session) {
  while (!session.isSettled()) {
    session.collect();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

std::size_t pulledVoxels(const scene::Scene& scene) {
  if (!scene.labels.data) return 0;
  Progress progress;
  auto sizes = countStructures(*scene.labels.data, progress);
  return sizes.contains(1) ? sizes[1].voxels : 0;
}

std::vector<std::uint16_t> pulledIds(const scene::Scene& scene) {
  const LabelVolume& labels = *scene.labels.data;
  std::vector<std::uint16_t> ids(std::size_t(kBarsEdge) * kBarsEdge * kBarsEdge);
  labels.read(glm::ivec3(0), labels.dims(), ids);
  return ids;
}

}  // namespace

TEST(StreamedPull, WhatAClickMeansIsAskedOfTheFinestLevel) {
  scene::Scene scene = barsScene();
  stream(scene);
  auto range = materialRangeAt(scene.volume, {8, 32, 8});
  ASSERT_TRUE(range);
  EXPECT_GT(range->low, 20.0);
  EXPECT_LE(range->low, 150.0);
  EXPECT_GE(range->high, 150.0);
  EXPECT_FALSE(materialRangeAt(scene.volume, {-8, 32, 8}));
  double coarse = valueAt(*scene.volume.data, {2, 8, 2});
  EXPECT_LT(coarse, 60.0) << "or the test says nothing";
}

TEST(StreamedPull, UndoTakesBackWhatHasGrownInTheFinestLevelAndRedoBringsIt) {
  scene::Scene scene = barsScene();
  auto source = stream(scene);
  Session session;
  session.document().replace(scene);
  auto pull = beginPull(session.scene(), session.scene().cuts[0].id, {8, 32, 8}, 0);
  ASSERT_TRUE(pull);
  session.document().edit("Pull", [&](scene::Scene& s) { pullTo(s, *pull, 10.0); });
  settlePulled(session);
  ASSERT_TRUE(session.scene().labels.data);
  EXPECT_EQ(session.scene().labels.data->dims(), glm::ivec3(kBarsEdge));
  EXPECT_EQ(pulledVoxels(session.scene()), 10u) << "ten deep";
  int reads = source->reads;
  EXPECT_LE(reads, 30) << "of 64: the neighbourhood of the click, and the bar";
  session.document().edit("Pull further", [&](scene::Scene& s) { pullTo(s, *pull, 20.0); });
  settlePulled(session);
  EXPECT_EQ(pulledVoxels(session.scene()), 20u);
  session.document().undo();
  settlePulled(session);
  EXPECT_EQ(pulledVoxels(session.scene()), 10u);
  session.document().undo();
  settlePulled(session);
  EXPECT_EQ(pulledVoxels(session.scene()), 0u);
  session.document().redo();
  session.document().redo();
  settlePulled(session);
  EXPECT_EQ(pulledVoxels(session.scene()), 20u);
}

TEST(StreamedPull, TypedStepsGiveTheVoxelsInMemory) {
  GrowStructure asked;
  asked.seeds = {{8, 32, 8}};
  asked.range = {100, 200};
  asked.strokes = {"12,10,12;12,30,12"};
  asked.plane = {0, -1, 0, -40};
  asked.distance = 37;
  asked.closing = 2.0;
  std::vector<std::uint16_t> ids[2];
  StructureValues values[2];
  for (bool isStreamed : {false, true}) {
    scene::Scene scene = barsScene();
    if (isStreamed) stream(scene);
    addGrowth(scene, stepOf(scene, asked), "bars");
    EXPECT_EQ(addSeeds(scene, 1, std::vector<glm::dvec3>{{16, 20, 16}, {17, 20, 17}}), 1u);
    EXPECT_EQ(addOthers(scene, 1, std::vector<glm::dvec3>{{40, 20, 41}}), 1u) << "the voxel beside it is meant";
    Progress progress;
    settleGrowths(scene, progress);
    ids[isStreamed] = pulledIds(scene);
    values[isStreamed] = measureValues(*scene.labels.data, *scene.volume.data, 0, 0, progress)[1];
  }
  EXPECT_EQ(ids[0], ids[1]);
  EXPECT_GT(values[0].voxels, 1000u);
  EXPECT_EQ(values[0].voxels, values[1].voxels);
  EXPECT_NEAR(values[0].mean, values[1].mean, 1e-9);
  EXPECT_EQ(values[0].least, values[1].least);
}

TEST(StreamedPull, ADamagedBrickIsSaidAndTheWindowLivesOn) {
  scene::Scene scene = barsScene();
  auto source = stream(scene);
  Session session;
  session.document().replace(scene);
  auto pull = beginPull(session.scene(), session.scene().cuts[0].id, {8, 32, 8}, 0);
  ASSERT_TRUE(pull);
  source->damaged = true;
  session.document().edit("Pull", [&](scene::Scene& s) { pullTo(s, *pull, scene::Growth::kEndless); });
  settlePulled(session);
  EXPECT_NE(session.growth().status().error.find("damaged"), std::string::npos) << session.growth().status().error;
  source->damaged = false;
  session.document().undo();
  session.document().edit("Pull", [&](scene::Scene& s) { pullTo(s, *pull, 12.0); });
  settlePulled(session);
  EXPECT_EQ(session.growth().status().error, "");
  EXPECT_EQ(pulledVoxels(session.scene()), 12u);
  // Nor does a press on what cannot be read.
  scene::Scene again = barsScene();
  auto lost = stream(again);
  lost->damaged = true;
  EXPECT_TRUE(materialRangeAt(again.volume, {8, 32, 8}));
  EXPECT_NO_THROW(beginPull(again, again.cuts[0].id, {8, 32, 8}, 0));
  again.labels.growths.push_back(*pull->growth);
  EXPECT_EQ(addSeeds(again, 1, std::vector<glm::dvec3>{{8, 32, 8}}), 0u);
  EXPECT_EQ(addOthers(again, 1, std::vector<glm::dvec3>{{8, 32, 8}}), 0u);
}

}  // namespace velum::session
