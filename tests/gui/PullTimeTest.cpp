// What was pulled out of a volume that moves stays out over its time steps.
#include "PullFixture.h"

namespace velum::gui {

namespace {

constexpr int kTimeEdge = 64, kSteps = 4;
constexpr double kTimePlane = 32.0, kRadius = 9.3, kTimeOut = 7.0;

glm::dvec3 middleOf(int timeStep) { return {14.0 + 11.0 * timeStep, kTimePlane, 32.0}; }

/// A ball that is somewhere else at each time step: it shares a little of its place with the step before.
int pullTimeBall(int x, int y, int z, int t) {
  return glm::distance(glm::dvec3(x, y, z), middleOf(t)) < kRadius ? 150 : 20;
}

}  // namespace

class PullTime : public PullFixture {
 protected:
  static void SetUpTestSuite() {
    Window::SetUpTestSuite();
    writeSeries(*sFolder / "series.nii", kTimeEdge, kSteps, pullTimeBall);
  }
  /// Voxels of the ball at a time step in front of the plane, as far as it is pulled.
  std::size_t out(int t, double distance) {
    std::size_t count = 0;
    for (int z = 0; z < kTimeEdge; ++z)
      for (int y = 0; y < kTimeEdge; ++y)
        for (int x = 0; x < kTimeEdge; ++x)
          count += y < kTimePlane && kTimePlane - y <= distance && pullTimeBall(x, y, z, t) == 150;
    return count;
  }
  /// What is seen out of the middle of the ball's place at a time step; 0: the structure does not stand out there.
  int seenOut(int t) {
    auto pick = viewport().pickAt(pixelOf(middleOf(t) + 0.6 * kTimeOut * session::pullDirection(cut(), middleOf(t))));
    bool standsOut = pick && pick->hit && session::depthInCut(cut(), pick->world) > 0.5;
    return standsOut ? pick->structure : 0;
  }
};

TEST_F(PullTime, WhatIsOutStaysOutAtEveryTimeStepWhereverItIsThen) {
  open({path("series.nii")});
  ASSERT_EQ(scene().volume.data->timeSteps, kSteps);
  document().edit("Look", [](scene::Scene& s) {
    s.volume.transfer.opacities = {{60, 0}, {80, 1}, {255, 1}};
    scene::Cut cut;
    cut.axis = {0, -1, 0};
    cut.centre = middleOf(1);
    scene::addCut(s, cut);
    s.camera = scene::frameCamera(s, scene::StandardView::Oblique, 1.0);
  });
  takeUp();
  pull(pixelOf(middleOf(0)), middleOf(0), cut(), kTimeOut);
  ASSERT_TRUE(settle());
  ASSERT_EQ(scene().labels.growths.size(), 1u);
  int structure = scene().labels.growths[0].structure;
  double distance = session::extrusionOf(cut(), structure);
  ASSERT_NEAR(distance, kTimeOut, 1.0);
  auto* list = child<QListWidget>("extrusionList");
  QString row = list->item(0)->text();
  auto expectOut = [&](int t) {
    SCOPED_TRACE(t);
    ASSERT_TRUE(settle());
    ASSERT_EQ(scene().volume.timeStep, t);
    EXPECT_TRUE(session::isGrown(scene()));
    EXPECT_EQ(voxelsOf(structure), out(t, distance));
    EXPECT_EQ(voxelsOf(structure, [t](glm::dvec3 p) { return pullTimeBall(int(p.x), int(p.y), int(p.z), t) == 150; }),
              out(t, distance));
    EXPECT_EQ(session::extrusionOf(cut(), structure), distance);
    EXPECT_EQ(seenOut(t), structure);
    for (int other = 0; other < kSteps; ++other) {
      if (std::abs(other - t) < 2) continue;  // seen obliquely it hides its neighbours' places
      EXPECT_EQ(seenOut(other), 0) << "seen at the place of " << other;
    }
    ASSERT_EQ(list->count(), 1);
    EXPECT_EQ(list->item(0)->text(), row);
  };
  expectOut(0);
  for (int t : {1, 2, 3, 0}) {
    press(".");
    expectOut(t);
  }
  takeShot(*mWindow, "pull-time");
  press(",");
  expectOut(3);
  EXPECT_TRUE(tool()) << "the tool stays up";
  EXPECT_EQ(document().undoLabel(), "Move view");
  document().undo();
  expectOut(0);
}

}  // namespace velum::gui
