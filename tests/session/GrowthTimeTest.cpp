// What was pulled out, at other time steps, with more seeds, and smoothed.
#include <gtest/gtest.h>

#include <chrono>
#include <random>
#include <thread>

#include "GrowthScene.h"
#include "session/Session.h"
#include "session/extrusion/Pull.h"

namespace velum::session {

namespace {

constexpr int kSeriesEdge = 48, kSteps = 8;

double middleOf(int timeStep) { return 12.0 + 3.5 * timeStep; }
bool isInBall(glm::ivec3 v, int timeStep) {
  return glm::distance(glm::dvec3(v), {middleOf(timeStep), 24.0, 24.0}) < 7.2;
}

scene::Scene ballScene() {
  return growthScene(kSeriesEdge, kSteps, [](glm::ivec3 v, int t) { return isInBall(v, t) ? 150 : 20; });
}

void pullAt(Session& session, glm::dvec3 place, double distance) {
  auto pull = beginPull(session.scene(), session.scene().cuts[0].id, place, 0);
  ASSERT_TRUE(pull);
  session.document().edit("Pull", [&](scene::Scene& s) { pullTo(s, *pull, distance); });
}

/// @param seen  called after every turn
void settle(
    Session& session, const std::function<void()>& seen = [] {}) {
  while (!session.isSettled()) {
    session.collect();
    seen();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

void goTo(Session& session, int timeStep) {
  session.document().edit(
      "Change time step", [&](scene::Scene& s) { s.volume.timeStep = timeStep; }, true);
}

template <class IsIn>
std::size_t differences(const scene::Scene& scene, int structure, const IsIn& isIn) {
  std::size_t wrong = 0;
  for (int z = 0; z < kSeriesEdge; ++z)
    for (int y = 0; y < kSeriesEdge; ++y)
      for (int x = 0; x < kSeriesEdge; ++x)
        wrong += (scene.labels.data->at({x, y, z}) == structure) != isIn(glm::ivec3(x, y, z));
  return wrong;
}

/// From what its steps give when they are done at once.
std::size_t differences(const scene::Scene& scene) {
  scene::Scene fresh = scene;
  fresh.labels.data = fresh.labels.given;
  fresh.labels.grown.clear();
  Progress progress;
  settleGrowths(fresh, progress);
  std::size_t wrong = 0;
  for (int z = 0; z < kSeriesEdge; ++z)
    for (int y = 0; y < kSeriesEdge; ++y)
      for (int x = 0; x < kSeriesEdge; ++x)
        wrong += fresh.labels.data->at({x, y, z}) != scene.labels.data->at({x, y, z});
  return wrong;
}

/// Of the ball at a time step, what lies up to seven before the plane.
auto outOfThePlane(int timeStep) {
  return [timeStep](glm::ivec3 v) { return isInBall(v, timeStep) && v.y < 24 && v.y >= 17; };
}

}  // namespace

TEST(GrowthTime, WhatIsPulledOutStaysOutAtEveryTimeStep) {
  Session session;
  session.document().replace(ballScene());
  pullAt(session, {middleOf(0), 24, 24}, 7.0);
  settle(session);
  for (int t : {1, 2, 3, 4, 5, 6, 7, 0, 7, 3}) {
    goTo(session, t);
    EXPECT_FALSE(isGrown(session.scene()));
    EXPECT_TRUE(session.isOnItsWay()) << "the time bar waits";
    settle(session);
    ASSERT_TRUE(isGrown(session.scene())) << t;
    EXPECT_EQ(differences(session.scene(), 1, outOfThePlane(t)), 0u) << t;
    EXPECT_EQ(extrusionOf(session.scene().cuts[0], 1), 7.0);
    EXPECT_EQ(session.scene().labels.growths.size(), 1u) << "one step, which is carried";
    EXPECT_EQ(session.scene().labels.growths[0].timeStep, 0);
  }
}

TEST(GrowthTime, NothingHalfGrownIsShownAtAnotherTimeStep) {
  Session session;
  session.document().replace(ballScene());
  pullAt(session, {middleOf(0), 24, 24}, 7.0);
  settle(session);
  goTo(session, 5);
  auto before = session.scene().labels.data;
  settle(session, [&] {
    const auto& now = session.scene().labels.data;
    if (now == before) return;
    ASSERT_EQ(differences(session.scene(), 1, outOfThePlane(5)), 0u);
  });
  EXPECT_FALSE(session.scene().labels.data == before);
}

TEST(GrowthTime, UndoGoesBackInTimeWithTheLabels) {
  Session session;
  session.document().replace(ballScene());
  pullAt(session, {middleOf(0), 24, 24}, 7.0);
  settle(session);
  goTo(session, 4);
  settle(session);
  session.document().endMerge();
  pullAt(session, {middleOf(4), 24, 24}, 3.0);
  settle(session);
  session.document().undo();
  settle(session);
  EXPECT_EQ(differences(session.scene(), 1, outOfThePlane(4)), 0u);
  session.document().undo();
  settle(session);
  EXPECT_EQ(session.scene().volume.timeStep, 0);
  EXPECT_EQ(differences(session.scene(), 1, outOfThePlane(0)), 0u);
}

TEST(GrowthTime, PulledFurtherElsewhereItIsFurtherOutEverywhere) {
  Session session;
  session.document().replace(ballScene());
  pullAt(session, {middleOf(0), 24, 24}, 3.0);
  settle(session);
  goTo(session, 6);
  settle(session);
  auto again = beginPull(session.scene(), session.scene().cuts[0].id, {middleOf(6), 24, 24}, 1);
  ASSERT_TRUE(again);
  for (double distance : {4.0, 5.5, 7.0})
    session.document().edit(
        "Pull", [&](scene::Scene& s) { pullTo(s, *again, distance); }, true);
  settle(session);
  for (int t : {6, 2, 0}) {
    goTo(session, t);
    settle(session);
    EXPECT_EQ(differences(session.scene(), 1, outOfThePlane(t)), 0u) << t;
  }
}

TEST(GrowthTime, MoreSeedsAreStepsOfTheirOwn) {
  // Two bars of the same values; what lies between has others.
  auto isBar = [](glm::ivec3 v) { return (v.x < 8 || v.x >= 40) && v.y > 4; };
  Session session;
  session.document().replace(growthScene(kSeriesEdge, 1, [&](glm::ivec3 v, int) { return isBar(v) ? 150 : 20; }));
  pullAt(session, {3, 24, 24}, 10.0);
  settle(session);
  auto one = session.scene().labels.data;
  std::vector<glm::dvec3> path{{30, 20, 24}, {44, 20, 24}, {44, 20, 24}, {44, 20, 500}};
  auto stroke = placesAlong(*session.scene().volume.data, path);
  EXPECT_EQ(stroke.size(), 15u + 23u) << "each voxel once, none outside";
  std::size_t count = 0;
  session.document().edit("More", [&](scene::Scene& s) { count = addSeeds(s, 1, stroke); });
  EXPECT_EQ(count, 5u + 23u) << "those of other values are none";
  settle(session);
  auto isOut = [&](glm::ivec3 v) { return isBar(v) && v.y < 24 && v.y >= 14; };
  EXPECT_EQ(differences(session.scene(), 1, isOut), 0u);
  EXPECT_EQ(differences(session.scene()), 0u);
  session.document().undo();
  settle(session);
  EXPECT_TRUE(session.scene().labels.data == one);
  scene::Scene scene = session.scene();
  EXPECT_EQ(addSeeds(scene, 1, std::vector<glm::dvec3>{{30, 20, 24}}), 0u);
  EXPECT_EQ(addSeeds(scene, 9, stroke), 0u) << "it was never grown";
  EXPECT_EQ(scene, session.scene());
}

TEST(GrowthTime, SmoothedItIsTheSameHoweverTheHandGoes) {
  // A bone with marrow and pores, and a fork that a closing joins.
  std::mt19937 random(3);
  auto scene = growthScene(kSeriesEdge, 1, [&](glm::ivec3 v, int) {
    double r = glm::length(glm::dvec2(v.x, v.z) - 23.5);
    bool isPore = (v.x * 7 + v.y * 3 + v.z * 5) % 11 == 0;
    return r < 12 && r > 6 && !isPore ? 150 : 20;
  });
  Session session;
  session.document().replace(scene);
  pullAt(session, {15, 24, 23}, 4.0);
  settle(session);
  session.document().edit("Smooth", [](scene::Scene& s) {
    changeGrowth(s, 1, [](scene::Growth& g) { g.closing = 1.5, g.fillHoles = true; });
  });
  settle(session);
  EXPECT_EQ(differences(session.scene()), 0u);
  EXPECT_EQ(session.scene().labels.data->at({23, 21, 23}), 1) << "marrow";
  auto again = beginPull(session.scene(), session.scene().cuts[0].id, {15, 22, 23}, 1);
  ASSERT_TRUE(again);
  for (int move = 0; move < 12; ++move) {
    session.document().edit(
        "Pull", [&](scene::Scene& s) { pullTo(s, *again, 2.0 + double(random() % 20)); }, true);
    for (int i = int(random() % 4); i > 0; --i) session.collect();
    if (move % 5 == 4) {
      settle(session);
      EXPECT_EQ(differences(session.scene()), 0u);
    }
  }
  session.document().edit("Move", [](scene::Scene& s) { s.cuts[0].centre.y = 30.0; });
  auto moved = beginPull(session.scene(), session.scene().cuts[0].id, {15, 22, 23}, 1);
  session.document().edit("Pull", [&](scene::Scene& s) { pullTo(s, *moved, 9.0); });
  settle(session);
  EXPECT_EQ(differences(session.scene()), 0u);
  EXPECT_EQ(session.scene().labels.data->at({23, 29, 23}), 1) << "marrow, down to the plane where it is now";
}

}  // namespace velum::session
