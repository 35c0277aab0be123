// Places that are not of a structure, said in a session: what grows without them, step by step of undo.
#include <gtest/gtest.h>

#include <chrono>
#include <random>
#include <thread>

#include "GrowthScene.h"
#include "session/Session.h"
#include "session/extrusion/Pull.h"

namespace velum::session {

namespace {

constexpr int kOthersEditEdge = 64;
constexpr glm::dvec3 kOnBar{32, 32, 32}, kInBlock{32, 10, 32}, kInOther{10, 31, 10};

/// A bar along y that opens into a block at y < 20, and one of other values beside it.
scene::Scene leakScene() {
  return growthScene(kOthersEditEdge, 1, [](glm::ivec3 v, int) {
    bool isBar = std::abs(v.x - 32) < 4 && std::abs(v.z - 32) < 4;
    bool isBlock = v.y < 20 && v.x > 2 && v.x < 62 && v.z > 2 && v.z < 62;
    return isBar || isBlock ? 150 : std::abs(v.x - 10) < 3 && std::abs(v.z - 10) < 3 ? 60 : 20;
  });
}

void othersEditSettle(Session& session) {
  while (!session.isSettled()) {
    session.collect();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

}  // namespace

class OthersEdit : public testing::Test {
 protected:
  void SetUp() override {
    mSession.document().replace(leakScene());
    mPull = beginPull(scene(), scene().cuts[0].id, kOnBar, 0);
    ASSERT_TRUE(mPull);
    pull(30.0);
    othersEditSettle(mSession);
  }
  const scene::Scene& scene() const { return mSession.scene(); }
  void pull(double distance) {
    mSession.document().edit(
        "Pull", [&](scene::Scene& s) { pullTo(s, *mPull, distance); }, true);
  }
  std::size_t sayNotThis(std::vector<glm::dvec3> places) {
    std::size_t count = 0;
    mSession.document().edit("Not this", [&](scene::Scene& s) { count = addOthers(s, mPull->structure, places); });
    othersEditSettle(mSession);
    return count;
  }
  std::size_t voxels(int firstY, int endY) const {
    std::size_t count = 0;
    for (int z = 0; z < kOthersEditEdge; ++z)
      for (int y = firstY; y < endY; ++y)
        for (int x = 0; x < kOthersEditEdge; ++x) count += scene().labels.data->at({x, y, z}) == mPull->structure;
    return count;
  }
  /// Its steps done at once give the same.
  bool isAsItsSteps() const {
    scene::Scene fresh = scene();
    fresh.labels.data = fresh.labels.given;
    fresh.labels.grown.clear();
    Progress progress;
    settleGrowths(fresh, progress);
    for (int z = 0; z < kOthersEditEdge; ++z)
      for (int y = 0; y < kOthersEditEdge; ++y)
        for (int x = 0; x < kOthersEditEdge; ++x)
          if (fresh.labels.data->at({x, y, z}) != scene().labels.data->at({x, y, z})) return false;
    return isGrown(scene());
  }

  Session mSession;
  std::optional<Pull> mPull;
};

TEST_F(OthersEdit, LetItGoOnWithoutWhatItWasHeldFor) {
  ASSERT_TRUE(mSession.growth().status().leak);
  std::size_t held = voxels(0, kOthersEditEdge);
  EXPECT_LT(scene().labels.growths[0].distance, 20.0);
  ASSERT_EQ(sayNotThis({kInBlock}), 1u);
  EXPECT_FALSE(mSession.growth().status().leak);
  EXPECT_DOUBLE_EQ(scene().labels.growths[0].distance, 30.0) << "as far as it is pulled";
  EXPECT_EQ(voxels(24, 32), 49u * 8) << "all of the bar but what lies at its mouth";
  EXPECT_LT(voxels(0, 16), 49u * 4) << "and nothing of the block but what lies at its mouth";
  EXPECT_TRUE(isAsItsSteps());
  mSession.document().undo();
  othersEditSettle(mSession);
  EXPECT_EQ(voxels(0, kOthersEditEdge), held);
  EXPECT_TRUE(scene().labels.growths[0].others.empty());
  mSession.document().redo();
  othersEditSettle(mSession);
  EXPECT_LT(voxels(0, 16), 49u * 4);
}

TEST_F(OthersEdit, AreStepsOfUndoEach) {
  ASSERT_EQ(sayNotThis({kInBlock}), 1u);
  ASSERT_EQ(sayNotThis({{10, 10, 50}, {50, 10, 10}}), 2u);
  EXPECT_EQ(scene().labels.growths[0].others.size(), 3u);
  mSession.document().undo();
  EXPECT_EQ(scene().labels.growths[0].others.size(), 1u);
  mSession.document().undo();
  EXPECT_EQ(scene().labels.growths[0].others.size(), 0u);
  othersEditSettle(mSession);
  EXPECT_TRUE(isGrown(scene()));
}

TEST_F(OthersEdit, WhereItCouldNotGrowChangeNothing) {
  scene::Scene before = scene();
  EXPECT_EQ(sayNotThis({kInOther}), 0u) << "other values";
  EXPECT_EQ(sayNotThis({{-50, 0, 0}}), 0u) << "outside";
  EXPECT_EQ(sayNotThis({scene().labels.growths[0].seeds[0]}), 0u) << "its own seed";
  EXPECT_EQ(sayNotThis({}), 0u);
  EXPECT_EQ(scene(), before);
  ASSERT_EQ(sayNotThis({kInBlock, kInBlock}), 1u) << "twice is once";
  EXPECT_EQ(sayNotThis({kInBlock}), 0u);
}

TEST_F(OthersEdit, CountBesideWhatTheyMean) {
  ASSERT_EQ(sayNotThis({{32, 10, 63}}), 1u) << "two voxels beside the block";
  EXPECT_LT(voxels(0, 16), 49u * 4);
}

TEST_F(OthersEdit, HoldHoweverTheHandPullsOn) {
  ASSERT_EQ(sayNotThis({kInBlock}), 1u);
  mPull = pullAgain(scene(), {scene().cuts[0].id, mPull->structure, 0.0});
  std::mt19937 random(3);
  for (int move = 0; move < 25; ++move) {
    pull(5.0 + double(random() % 26));
    for (int i = int(random() % 3); i > 0; --i) mSession.collect();
  }
  othersEditSettle(mSession);
  EXPECT_TRUE(isAsItsSteps());
  EXPECT_LT(voxels(0, 16), 49u * 4);
}

TEST_F(OthersEdit, AreToldToEachStepOfIt) {
  // A second step, from a stroke, that leaks as the first did.
  mSession.document().edit("Add", [&](scene::Scene& s) { addSeeds(s, mPull->structure, std::vector{kOnBar}); });
  ASSERT_EQ(scene().labels.growths.size(), 2u);
  ASSERT_EQ(sayNotThis({kInBlock}), 1u);
  for (const auto& step : scene().labels.growths) EXPECT_EQ(step.others.size(), 1u);
  EXPECT_LT(voxels(0, 16), 49u * 4);
  EXPECT_TRUE(isAsItsSteps());
}

}  // namespace velum::session
