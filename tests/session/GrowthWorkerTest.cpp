// Regions that grow beside the document.
#include "session/growth/GrowthWorker.h"

#include <gtest/gtest.h>

#include <chrono>
#include <random>
#include <thread>

#include "GrowthScene.h"
#include "growth/Grower.h"
#include "growth/LabelsFor.h"
#include "session/Session.h"
#include "session/command/Command.h"
#include "session/document/Open.h"
#include "session/extrusion/Pull.h"

namespace velum::session {

namespace {

constexpr int kEdge = 64;

/// Bars along y, every fourth voxel, joined at y = 5.
scene::Scene combScene() {
  return growthScene(kEdge, 1, [](glm::ivec3 v, int) { return v.y == 5 || (v.x % 4 == 0 && v.z % 4 == 0) ? 150 : 20; });
}

/// A bar along y that opens into a block, which lies so deep before the plane.
scene::Scene leakScene(int deep = 12) {
  return growthScene(kEdge, 1, [deep](glm::ivec3 v, int) {
    bool isBar = std::abs(v.x - 32) < 4 && std::abs(v.z - 32) < 4;
    bool isBlock = v.y < kEdge / 2 - deep && v.x > 2 && v.x < 62 && v.z > 2 && v.z < 62;
    return isBar || isBlock ? 150 : 20;
  });
}

void growthWorkerSettle(Session& session) {
  while (!session.isSettled()) {
    session.collect();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

/// What the scene's steps give when they are done at once.
std::size_t growthWorkerDifferences(const scene::Scene& scene) {
  scene::Scene fresh = scene;
  fresh.labels.data = fresh.labels.given;
  fresh.labels.grown.clear();
  Progress progress;
  settleGrowths(fresh, progress);
  std::size_t wrong = 0;
  for (int z = 0; z < kEdge; ++z)
    for (int y = 0; y < kEdge; ++y)
      for (int x = 0; x < kEdge; ++x) wrong += fresh.labels.data->at({x, y, z}) != scene.labels.data->at({x, y, z});
  return wrong;
}

std::size_t voxelsOf(const scene::Scene& scene, int structure) {
  std::size_t count = 0;
  for (int z = 0; scene.labels.data && z < kEdge; ++z)
    for (int y = 0; y < kEdge; ++y)
      for (int x = 0; x < kEdge; ++x) count += scene.labels.data->at({x, y, z}) == structure;
  return count;
}

}  // namespace

TEST(GrowthWorker, HoweverTheHandGoesTheLabelsAreThoseOfTheSteps) {
  std::mt19937 random(7);
  Session session;
  session.document().replace(combScene());
  auto& document = session.document();
  int cut = session.scene().cuts[0].id;
  for (int drag = 0; drag < 4; ++drag) {
    glm::dvec3 click(4.0 * double(random() % 15), 32, 4.0 * double(random() % 15));
    auto pull = beginPull(session.scene(), cut, click,
                          session.scene().labels.data ? session.scene().labels.data->at(glm::ivec3(click)) : 0);
    ASSERT_TRUE(pull);
    for (int move = 0; move < 12; ++move) {
      document.edit(
          "Pull", [&](scene::Scene& s) { pullTo(s, *pull, 1.0 + double(random() % 30)); }, true);
      for (int i = int(random() % 3); i > 0; --i) session.collect();
    }
    document.endMerge();
    if (drag == 2) document.edit("Move", [](scene::Scene& s) { s.cuts[0].centre.y = 40.0; });
  }
  growthWorkerSettle(session);
  ASSERT_TRUE(isGrown(session.scene()));
  EXPECT_EQ(growthWorkerDifferences(session.scene()), 0u);
  EXPECT_GT(voxelsOf(session.scene(), 1), 10u);
}

TEST(GrowthWorker, UndoTakesBackWhatHasGrownAndRedoBringsIt) {
  Session session;
  session.document().replace(combScene());
  auto pull = beginPull(session.scene(), session.scene().cuts[0].id, {8, 32, 8}, 0);
  ASSERT_TRUE(pull);
  session.document().edit("Pull", [&](scene::Scene& s) { pullTo(s, *pull, 10.0); });
  growthWorkerSettle(session);
  std::size_t first = voxelsOf(session.scene(), 1);
  EXPECT_EQ(first, 10u) << "ten deep";
  session.document().edit("Pull further", [&](scene::Scene& s) { pullTo(s, *pull, 20.0); });
  growthWorkerSettle(session);
  EXPECT_EQ(voxelsOf(session.scene(), 1), 20u);
  session.document().undo();
  growthWorkerSettle(session);
  EXPECT_EQ(voxelsOf(session.scene(), 1), first);
  session.document().undo();
  growthWorkerSettle(session);
  EXPECT_EQ(voxelsOf(session.scene(), 1), 0u);
  EXPECT_TRUE(session.scene().labels.structures.empty());
  session.document().redo();
  session.document().redo();
  growthWorkerSettle(session);
  EXPECT_EQ(voxelsOf(session.scene(), 1), 20u);
  EXPECT_EQ(growthWorkerDifferences(session.scene()), 0u);
}

TEST(GrowthWorker, AnotherRangeGrowsAnewFromTheSeeds) {
  Session session;
  session.document().replace(combScene());
  auto pull = beginPull(session.scene(), session.scene().cuts[0].id, {8, 32, 8}, 0);
  ASSERT_TRUE(pull);
  session.document().edit("Pull", [&](scene::Scene& s) { pullTo(s, *pull, 10.0); });
  growthWorkerSettle(session);
  session.document().edit(
      "Everything", [](scene::Scene& s) { changeGrowth(s, 1, [](scene::Growth& g) { g.low = 0.0, g.high = 255.0; }); });
  growthWorkerSettle(session);
  EXPECT_EQ(voxelsOf(session.scene(), 1), std::size_t(kEdge) * kEdge * 10) << "all that is ten deep";
  EXPECT_EQ(growthWorkerDifferences(session.scene()), 0u);
}

TEST(GrowthWorker, WhatLeaksIsHeldAndSaidAndMayGoOn) {
  Session session;
  session.document().replace(leakScene());
  auto pull = beginPull(session.scene(), session.scene().cuts[0].id, {32, 32, 32}, 0);
  ASSERT_TRUE(pull);
  session.document().edit("Pull", [&](scene::Scene& s) { pullTo(s, *pull, 25.0); });
  growthWorkerSettle(session);
  auto leak = session.growth().status().leak;
  ASSERT_TRUE(leak);
  EXPECT_GT(leak->times, 2.0);
  EXPECT_LE(leak->distance, 12.5) << "the block begins 12 deep";
  EXPECT_GE(leak->distance, 5.0);
  EXPECT_LT(voxelsOf(session.scene(), 1), 1000u) << "the picture is not flooded";
  EXPECT_EQ(session.scene().labels.growths.back().distance, leak->distance);
  EXPECT_EQ(extrusionOf(session.scene().cuts[0], 1), 25.0) << "it stays pulled as far as the hand has";
  // As a line of a script does it, so that the commands so far lead there again.
  Progress progress;
  run(session, parseCall("growth.growOn 1"), progress);
  growthWorkerSettle(session);
  EXPECT_FALSE(session.growth().status().leak);
  EXPECT_GT(voxelsOf(session.scene(), 1), 20000u);
  EXPECT_EQ(growthWorkerDifferences(session.scene()), 0u);
}

/// Two halves: one of what is clicked on is most of what there is.
TEST(GrowthWorker, WhatIsMostOfThePlaneIsAskedForBeforeItGrows) {
  Session session;
  scene::Scene scene = growthScene(kEdge, 1, [](glm::ivec3 v, int) {
    return v.x < kEdge - 6 ? 150 : v.x < kEdge - 3 ? 90 : 20;
  });
  session.document().replace(scene);
  glm::dvec3 middle = session.scene().cuts[0].centre;
  auto pull = beginPull(session.scene(), session.scene().cuts[0].id, middle, 0);
  ASSERT_TRUE(pull);
  for (double distance : {0.4, 2.0, 9.0}) {
    session.document().edit(
        "Pull", [&](scene::Scene& s) { pullTo(s, *pull, distance); }, true);
    growthWorkerSettle(session);
  }
  auto leak = session.growth().status().leak;
  ASSERT_TRUE(leak);
  EXPECT_EQ(leak->times, 0.0);
  EXPECT_LT(leak->distance, 1.0) << "before it grows, however the hand began";
  EXPECT_LT(voxelsOf(session.scene(), pull->structure), std::size_t(kEdge) * kEdge);
  session.growth().trust(pull->structure);
  session.document().edit("Grow on", [&](scene::Scene& s) { growOn(s, pull->structure); });
  growthWorkerSettle(session);
  EXPECT_FALSE(session.growth().status().leak);
  EXPECT_GT(voxelsOf(session.scene(), pull->structure), std::size_t(kEdge) * kEdge * 7);
}

TEST(GrowthWorker, WhatReachesTheDarkestIsAskedForUnlessSomebodyHasTypedIt) {
  Session session;
  session.document().replace(leakScene());
  auto pull = beginPull(session.scene(), session.scene().cuts[0].id, {32, 32, 32}, 0);
  ASSERT_TRUE(pull && pull->growth);
  pull->growth->low = 0.0;
  session.document().edit("Pull", [&](scene::Scene& s) { pullTo(s, *pull, 8.0); });
  growthWorkerSettle(session);
  ASSERT_TRUE(session.growth().status().leak);
  EXPECT_EQ(session.growth().status().leak->distance, 0.0);
  EXPECT_LE(voxelsOf(session.scene(), 1), 1u);
  // The same values, typed.
  session.document().edit("Values",
                          [](scene::Scene& s) { changeGrowth(s, 1, [](scene::Growth& g) { g.high = 199.0; }); });
  growthWorkerSettle(session);
  EXPECT_FALSE(session.growth().status().leak);
  EXPECT_GT(voxelsOf(session.scene(), 1), 10000u);
}

/// Parts are of two slabs, and of more where they are quickly done: the leak lies anywhere in one.
TEST(GrowthWorker, WhatLeaksIsHeldWhereTheGuardSaysHoweverManySlabsAreGrownAtATime) {
  for (int deep = 6; deep <= 27; deep += 3) {
    SCOPED_TRACE(deep);
    Session session;
    session.document().replace(leakScene(deep));
    auto pull = beginPull(session.scene(), session.scene().cuts[0].id, {32, 32, 32}, 0);
    ASSERT_TRUE(pull);
    session.document().edit("Pull", [&](scene::Scene& s) { pullTo(s, *pull, 31.0); });
    const scene::Growth whole = session.scene().labels.growths.back();
    const auto& volume = session.scene().volume.data;
    Progress progress;
    growth::Grown guarded =
        growth::Grower().grow(volume, growth::labelsFor(*volume, {}), whole, {.guard = true, .begun = {}}, progress);
    ASSERT_TRUE(guarded.leak);
    growthWorkerSettle(session);
    auto leak = session.growth().status().leak;
    ASSERT_TRUE(leak);
    EXPECT_DOUBLE_EQ(leak->distance, guarded.distance);
    EXPECT_EQ(voxelsOf(session.scene(), 1), guarded.voxels) << "nothing of it is lost that was safe";
  }
}

TEST(GrowthWorker, WhatIsStoppedStaysAsItIs) {
  Session session;
  session.document().replace(growthScene(kEdge, 1, [](glm::ivec3, int) { return 150; }));
  auto pull = beginPull(session.scene(), session.scene().cuts[0].id, {32, 32, 32}, 0);
  ASSERT_TRUE(pull);
  session.document().edit("Pull", [&](scene::Scene& s) { pullTo(s, *pull, 30.0); });
  session.collect();
  Progress progress;
  run(session, parseCall("growth.stop"), progress);
  growthWorkerSettle(session);
  EXPECT_TRUE(isGrown(session.scene()));
  // Run again, a script waits until all has grown: so it says by fields how far this had come.
  for (const std::string& line : session.document().commandLines()) EXPECT_EQ(line.find("growth.stop"), line.npos);
  EXPECT_EQ(growthWorkerDifferences(session.scene()), 0u);
}

TEST(GrowthWorker, ASceneThatIsLoadedHasGrownWhatItsStepsSay) {
  scene::Scene scene = combScene();
  Progress progress;
  pullTo(scene, *beginPull(scene, scene.cuts[0].id, {8, 32, 8}, 0), 29.0);
  loadData(scene, {}, progress);
  EXPECT_TRUE(isGrown(scene));
  EXPECT_GT(voxelsOf(scene, 1), 1000u) << "over the joint at y = 5 and down the other bars";
}

}  // namespace velum::session
