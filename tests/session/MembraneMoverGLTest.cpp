#include "session/membrane/MembraneMover.h"

#include "GlFixture.h"
#include "makeVolume.h"
#include "membrane/sheet/Simulation.h"
#include "session/cut/CutEdit.h"
#include "session/membrane/DefaultField.h"

namespace velum::session {
namespace {

/// Balls in a row, a little off the middle of the data, across which the membrane hangs.
/// @param finer  voxels along an edge for one
scene::Scene ballScene(int finer = 1) {
  glm::ivec3 dims = glm::ivec3(40, 40, 32) * finer;
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(makeVolume(
      dims, SampleType::Int16,
      [finer](glm::ivec3 p) {
        double ball = std::min(glm::length(glm::dvec3(p) - glm::dvec3(12, 20, 18) * double(finer)),
                               glm::length(glm::dvec3(p) - glm::dvec3(28, 20, 13) * double(finer)));
        return ball < 5 * finer ? 800.0 : -1000.0;
      },
      centredFrame(dims)));
  scene::Cut cut;
  cut.shape = scene::CutShape::Membrane;
  cut.membrane.emplace();
  cut.axis = {0, 0, 1};
  cut.size = glm::dvec3(40, 40, 24) * double(finer);
  cut.membrane->cloth.particles = {20, 20};
  cut.membrane->field.byValue = {{0, 400}, {1000, 400}};
  scene::addCut(scene, cut);
  return scene;
}

class MembraneMoverGL : public GlTest {
 protected:
  void work() {
    Progress progress;
    if (auto work = mPlayer.nextWork()) mPlayer.endWork(work(progress));
  }
  void settle(double budgetMs = 8.0) { settle(mPlayer, budgetMs); }
  static void settle(MembraneMover& player, double budgetMs) {
    Progress progress;
    for (int i = 0; i < 3000 && !player.isSettled(); ++i) {
      if (auto work = player.nextWork()) player.endWork(work(progress));
      player.advance(budgetMs);
    }
    ASSERT_TRUE(player.isSettled());
  }
  static scene::SheetShape shapeOf(const MembraneMover& player, const scene::Scene& scene) {
    return player.withShapes(scene).cuts[0].membrane->shape;
  }
  void TearDown() override {
    mPlayer.releaseGpu();
    GlTest::TearDown();
  }
  MembraneMover mPlayer;
};

TEST_F(MembraneMoverGL, ComesToRestAndKeepsWholeWhatThePlaneCuts) {
  mPlayer.follow(ballScene());
  settle();
  MembraneStatus status = *mPlayer.status(1);
  EXPECT_EQ(status.phase, MembraneStatus::Phase::Resting);
  EXPECT_GT(status.kernels, 0u);
  ASSERT_TRUE(status.isMeasured);
  EXPECT_GT(status.planePairs, 50);
  EXPECT_LT(status.keptWhole, 0.3);
  EXPECT_GT(status.meanDistance, 0.1);
}

TEST_F(MembraneMoverGL, AtRestThereIsNothingToDo) {
  scene::Scene scene = ballScene();
  mPlayer.follow(scene);
  settle();
  auto sheets = mPlayer.sheets();
  int steps = mPlayer.status(1)->steps;
  auto shown = mPlayer.shownCount();
  for (int i = 0; i < 5; ++i) {
    scene.camera.eye.x += 1.0;  // looking from elsewhere moves no sheet
    scene.cuts[0].name += "x";
    scene.cuts[0].membrane->inlayOpacity *= 0.9;
    mPlayer.follow(scene);
    EXPECT_FALSE(mPlayer.isMoving());
    EXPECT_FALSE(mPlayer.nextWork());
    EXPECT_FALSE(mPlayer.advance(8.0));
    EXPECT_TRUE(mPlayer.isSettled());
  }
  EXPECT_EQ(mPlayer.status(1)->steps, steps);
  EXPECT_EQ(mPlayer.shownCount(), shown);
  EXPECT_EQ(mPlayer.sheets(), sheets);
}

TEST_F(MembraneMoverGL, WhereItRestsDoesNotDependOnHowLongAPieceOfWorkIs) {
  scene::Scene scene = ballScene();
  mPlayer.follow(scene);
  settle(0.0);
  MembraneMover other;
  other.follow(scene);
  settle(other, 100.0);
  EXPECT_EQ(shapeOf(mPlayer, scene), shapeOf(other, scene));
  other.releaseGpu();
}

TEST_F(MembraneMoverGL, APassiveSheetRestsWhereItWouldHaveFromTheStart) {
  scene::Scene scene = ballScene();
  mPlayer.follow(scene);
  settle();
  scene::SheetShape before = shapeOf(mPlayer, scene);
  scene.cuts[0].centre.z += 2.0;
  mPlayer.follow(scene);
  // Until the new forces are there it stays in the world where it was, with its rim on the frame.
  scene::SheetShape between = shapeOf(mPlayer, scene);
  std::size_t middle = before.places.size() / 2 + std::size_t(before.particles.x) / 2;
  EXPECT_NEAR(between.places[middle].z, before.places[middle].z - 2.0, 0.3);
  EXPECT_EQ(between.places[0].z, 0.0f);
  settle();
  MembraneMover fresh;
  fresh.follow(scene);
  settle(fresh, 8.0);
  EXPECT_EQ(shapeOf(mPlayer, scene), shapeOf(fresh, scene));
  fresh.releaseGpu();
}

TEST_F(MembraneMoverGL, ASteadyDragSeesTheForcesOfPlacesOnItsWay) {
  scene::Scene scene = ballScene();
  mPlayer.follow(scene);
  settle();
  Progress progress;
  auto arrived = mPlayer.nextWork();
  EXPECT_FALSE(arrived);
  scene.cuts[0].centre.z += 1.0;
  mPlayer.follow(scene);
  auto work = mPlayer.nextWork();
  ASSERT_TRUE(work);
  auto finish = work(progress);
  scene.cuts[0].centre.z += 1.0;
  mPlayer.follow(scene);
  EXPECT_FALSE(mPlayer.wantsCancel());
  EXPECT_FALSE(mPlayer.nextWork()) << "one at a time";
  mPlayer.endWork(finish);
  EXPECT_TRUE(mPlayer.isMoving());
  EXPECT_TRUE(mPlayer.nextWork()) << "and the newest next";
}

TEST_F(MembraneMoverGL, InLargeDataALookComesBeforeExactForces) {
  scene::Scene scene = ballScene(5);
  ASSERT_GT(40.0 * 40.0 * 32.0 * 125.0, membrane::ForceMaker::kLargeVoxels);
  mPlayer.follow(scene);
  work();
  EXPECT_TRUE(mPlayer.isMoving()) << "by the look";
  EXPECT_EQ(mPlayer.status(1)->phase, MembraneStatus::Phase::Computing) << "exact forces are to come";
  for (int i = 0; i < 20; ++i) mPlayer.advance(50.0);
  auto height = membrane::heightOf(shapeOf(mPlayer, scene));
  EXPECT_GT(std::abs(height({-40, 0})), 2.5) << "it is pushed aside";
  auto exact = mPlayer.nextWork();
  ASSERT_TRUE(exact);
  scene.cuts[0].centre.z += 4.0;
  mPlayer.follow(scene);
  EXPECT_TRUE(mPlayer.wantsCancel()) << "a drag does not wait for exact forces";
  mPlayer.endWork({});
  settle();
  MembraneMover fresh;
  fresh.follow(scene);
  settle(fresh, 8.0);
  EXPECT_EQ(shapeOf(mPlayer, scene), shapeOf(fresh, scene));
  EXPECT_LT(mPlayer.status(1)->keptWhole, 0.1);
}

/// Drags a pin or a kernel, and looks at what is shown meanwhile.
TEST_F(MembraneMoverGL, TheSheetFollowsAHandAndRestsWhereItWouldHaveFromTheStart) {
  scene::Scene scene = ballScene();
  mPlayer.follow(scene);
  settle();
  scene::SheetShape before = shapeOf(mPlayer, scene);
  for (double strength : {0.0, -1000.0, 500.0}) {  // a pin, a kernel that pulls, one that pushes
    scene::Scene dragged = scene;
    double seen = 0.0;
    for (int i = 1; i <= 12; ++i) {
      auto& membrane = *dragged.cuts[0].membrane;
      glm::dvec3 place(0, -12, 0.5 * i);
      if (strength == 0.0)
        membrane.pins = {{{0.5, 0.2}, place}};
      else
        membrane.field.kernels = {{place, 8.0, strength}};
      mPlayer.follow(dragged);
      work();
      mPlayer.advance(20.0);
      auto height = membrane::heightOf(shapeOf(mPlayer, dragged));
      seen = std::max(seen, std::abs(height(place)));
    }
    EXPECT_GT(seen, 1.0) << "a steady drag is followed, not only its end";
    settle();
    MembraneMover fresh;
    fresh.follow(dragged);
    settle(fresh, 8.0);
    EXPECT_EQ(shapeOf(mPlayer, dragged), shapeOf(fresh, dragged));
    mPlayer.follow(scene);  // undone
    settle();
    EXPECT_EQ(shapeOf(mPlayer, scene), before);
  }
}

TEST_F(MembraneMoverGL, WorkForDataThatIsGoneIsCancelled) {
  scene::Scene scene = ballScene();
  mPlayer.follow(scene);
  ASSERT_TRUE(mPlayer.nextWork());
  EXPECT_FALSE(mPlayer.wantsCancel());
  scene::Scene other = ballScene();  // the same voxels under another id
  mPlayer.follow(other);
  EXPECT_TRUE(mPlayer.wantsCancel());
  mPlayer.endWork({});
  EXPECT_TRUE(mPlayer.nextWork());
  mPlayer.follow(scene::Scene());
  EXPECT_TRUE(mPlayer.wantsCancel());
}

TEST_F(MembraneMoverGL, AnActiveSheetIsWrittenDownOnceAndComesBackWithoutWork) {
  scene::Scene scene = ballScene();
  scene.cuts[0].membrane->repositioning = scene::Repositioning::Active;
  mPlayer.follow(scene);
  EXPECT_TRUE(mPlayer.takeRests().empty());
  settle();
  auto rests = mPlayer.takeRests();
  ASSERT_EQ(rests.size(), 1u);
  EXPECT_TRUE(mPlayer.takeRests().empty());
  scene.cuts[0].membrane->shape = rests[0].shape;
  mPlayer.follow(scene);
  EXPECT_TRUE(mPlayer.isSettled());
  MembraneMover reopened;
  reopened.follow(scene);
  EXPECT_FALSE(reopened.advance(8.0));
  EXPECT_FALSE(reopened.isMoving());
  EXPECT_EQ(reopened.status(1)->steps, 0);
  EXPECT_EQ(shapeOf(reopened, scene), rests[0].shape);
  reopened.releaseGpu();
}

TEST_F(MembraneMoverGL, AnActiveSheetStaysBehindOnWhatHoldsIt) {
  scene::Scene scene = ballScene();
  scene.cuts[0].membrane->repositioning = scene::Repositioning::Active;
  mPlayer.follow(scene);
  settle();
  scene::Scene old = mPlayer.withShapes(scene);
  mPlayer.takeRests();
  scene = old;
  mPlayer.follow(scene);
  for (int i = 0; i < 4; ++i) {
    scene.cuts[0].centre.z += 1.0;
    mPlayer.follow(scene);
    settle();
    for (auto& rest : mPlayer.takeRests()) scene.cuts[0].membrane->shape = rest.shape;
    mPlayer.follow(scene);
  }
  EXPECT_LT(mPlayer.status(1)->keptWhole, 0.5);
  // What is undone comes back as it rested.
  mPlayer.follow(old);
  EXPECT_EQ(shapeOf(mPlayer, old), old.cuts[0].membrane->shape);
  EXPECT_FALSE(mPlayer.status(1)->phase == MembraneStatus::Phase::Settling);
}

TEST_F(MembraneMoverGL, PausedItStandsAndStepsByHand) {
  mPlayer.follow(ballScene());
  work();
  mPlayer.setPlaying(false);
  mPlayer.advance(8.0);
  int steps = mPlayer.status(1)->steps;
  EXPECT_EQ(mPlayer.status(1)->phase, MembraneStatus::Phase::Paused);
  EXPECT_TRUE(mPlayer.stepOnce());
  EXPECT_GT(mPlayer.status(1)->steps, steps);
  mPlayer.setPlaying(true);
  settle();
  mPlayer.reset(1);
  EXPECT_FALSE(mPlayer.isSettled());
  settle();
}

TEST_F(MembraneMoverGL, WhatTheDriverLosesIsMadeAgain) {
  scene::Scene scene = ballScene();
  mPlayer.follow(scene);
  settle();
  auto before = shapeOf(mPlayer, scene);
  auto sheet = mPlayer.sheets();
  ASSERT_EQ(sheet.size(), 1u);
  ASSERT_TRUE(sheet[1].sheet);
  sheet.clear();
  mPlayer.releaseGpu();
  EXPECT_TRUE(mPlayer.isSettled());
  EXPECT_EQ(mPlayer.sheets()[1].sheet->shape(), before);
  // In the middle of the way it goes on from there.
  scene.cuts[0].centre.z += 1.0;
  mPlayer.follow(scene);
  work();
  mPlayer.advance(1.0);
  mPlayer.releaseGpu();
  settle();
  EXPECT_LT(mPlayer.status(1)->keptWhole, 0.5);
}

TEST_F(MembraneMoverGL, SheetsAreOfTheEnabledMembranesByTheIdsOfTheirCuts) {
  scene::Scene scene = ballScene();
  scene::Cut plane, flat = scene.cuts[0];
  flat.membrane->field = {};
  flat.size.x = 30;
  scene.cuts = {plane, flat, scene.cuts[0]};
  for (int i = 0; i < 3; ++i) scene.cuts[std::size_t(i)].id = 10 * (i + 1);
  mPlayer.follow(scene);
  settle();
  EXPECT_FALSE(mPlayer.status(10));
  auto sheets = mPlayer.sheets();
  ASSERT_EQ(sheets.size(), 2u);
  EXPECT_EQ(sheets.at(20).sheet->size().x, 30.0);
  int steps = mPlayer.status(30)->steps;
  std::swap(scene.cuts[1], scene.cuts[2]);
  mPlayer.follow(scene);
  EXPECT_TRUE(mPlayer.isSettled()) << "moving a cut in the list moves no sheet";
  EXPECT_EQ(mPlayer.status(30)->steps, steps);
  scene.cuts[1].enabled = false;
  mPlayer.follow(scene);
  EXPECT_EQ(mPlayer.sheets().size(), 1u);
  scene.cuts[1].enabled = true;
  scene.cuts[1].centre.z += 1.0;
  scene.cuts.erase(scene.cuts.begin());
  mPlayer.follow(scene);
  EXPECT_FALSE(mPlayer.status(10));
  EXPECT_TRUE(mPlayer.status(30)) << "it is known by its id, though it stands elsewhere and in another place";
}

TEST(DefaultField, ProtectsWhatIsShownMostOpaque) {
  scene::Scene scene = ballScene();
  scene.volume.transfer.opacities = {{-1000, 0.0}, {-500, 0.01}, {0, 0.05}, {500, 0.9}, {800, 1.0}};
  auto field = defaultField(scene);
  ASSERT_FALSE(field.byValue.empty());
  EXPECT_LE(field.byValue.front().value, 800.0);
  EXPECT_GT(field.byValue.front().value, -900.0);
  EXPECT_TRUE(defaultField(scene::Scene()).byValue.empty());
}

}  // namespace
}  // namespace velum::session
