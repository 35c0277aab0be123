#include "session/model/LevelWorker.h"

#include <gtest/gtest.h>

#include "TempFolder.h"
#include "core/Error.h"
#include "io/models/WriteModel.h"
#include "makeModel.h"
#include "model/Levels.h"
#include "scene/Scene.h"
#include "session/Rest.h"
#include "session/Session.h"
#include "session/document/Open.h"
#include "session/model/LevelCache.h"
#include "session/model/TrueLevels.h"

namespace velum::session {
namespace {

class LevelWorkerCase : public testing::Test {
 protected:
  LevelSet computed() { return model::computeLevels(*mModel, mProgress); }
  scene::Scene withQuickLevels() {
    scene::Scene scene;
    scene.model.data = mModel;
    scene.model.levels = Shared<LevelSet>(model::makeQuickLevels(*mModel, mProgress));
    return scene;
  }
  void bringToRest(scene::Scene& scene) {
    mWorker.follow(scene);
    session::bringToRest(
        mWorker,
        [&] {
          mWorker.complete(scene);
          mWorker.follow(scene);
        },
        mProgress);
  }

  TempFolder mFolder;
  Progress mProgress;
  Shared<Model> mModel{ModelMaker{.atoms = 400}.make()};
  LevelWorker mWorker{mFolder / "levels"};
};

TEST_F(LevelWorkerCase, QuickLevelsAreReplacedByThoseThatAreComputed) {
  scene::Scene scene = withQuickLevels();
  EXPECT_FALSE(*scene.model.levels == computed());
  mWorker.follow(scene);
  EXPECT_TRUE(mWorker.isOnItsWay());
  EXPECT_EQ(mWorker.fractionDone(), 0.0);
  bringToRest(scene);
  EXPECT_EQ(*scene.model.levels, computed());
  EXPECT_TRUE(mWorker.isSettled());
  EXPECT_FALSE(mWorker.fractionDone());
  EXPECT_TRUE(std::filesystem::exists(levelFile(*mModel, mFolder / "levels"))) << "so that nobody waits the next time";
}

TEST_F(LevelWorkerCase, LevelsThatAreThereOrThatNobodyHasAskedForAreLeftAlone) {
  scene::Scene scene = withQuickLevels();
  scene.model.levels = Shared<LevelSet>(computed());
  mWorker.follow(scene);
  EXPECT_FALSE(mWorker.nextWork());
  scene.model.levels = {};
  mWorker.follow(scene);
  EXPECT_FALSE(mWorker.nextWork());
}

/// An undo brings a scene back that was made before the levels were there.
TEST_F(LevelWorkerCase, QuickLevelsThatComeBackAreReplacedAtOnce) {
  scene::Scene scene = withQuickLevels(), before = scene;
  bringToRest(scene);
  mWorker.follow(before);
  EXPECT_FALSE(mWorker.isOnItsWay());
  EXPECT_FALSE(mWorker.nextWork());
  ASSERT_TRUE(mWorker.hasRests());
  mWorker.complete(before);
  EXPECT_EQ(before.model.levels, scene.model.levels);
}

TEST_F(LevelWorkerCase, WorkForAModelThatHasGoneIsGivenUp) {
  mWorker.follow(withQuickLevels());
  Worker::Work work = mWorker.nextWork();
  ASSERT_TRUE(work);
  EXPECT_FALSE(mWorker.wantsCancel());
  mWorker.follow(scene::Scene());
  EXPECT_TRUE(mWorker.wantsCancel());
  mProgress.cancel();
  EXPECT_THROW(work(mProgress), Cancelled);
  mWorker.endWork({}, {});
  EXPECT_TRUE(mWorker.isSettled());
  EXPECT_FALSE(mWorker.hasRests());
}

/// Another model was opened while the last piece of the work was on its way.
TEST_F(LevelWorkerCase, LevelsOfOneModelAreNeverGivenToAnother) {
  mWorker.follow(withQuickLevels());
  Worker::Finish finish = mWorker.nextWork()(mProgress);
  mModel = Shared<Model>(ModelMaker{.types = 2, .atoms = 30, .seed = 9}.make());
  scene::Scene other = withQuickLevels();
  mWorker.follow(other);
  mWorker.endWork(finish, {});
  EXPECT_FALSE(mWorker.hasRests());
  bringToRest(other);
  EXPECT_EQ(*other.model.levels, computed());
}

TEST_F(LevelWorkerCase, WorkThatHasFailedIsNotBegunAgain) {
  mWorker.follow(withQuickLevels());
  ASSERT_TRUE(mWorker.nextWork());
  mWorker.endWork({}, "no memory");
  EXPECT_FALSE(mWorker.nextWork());
  EXPECT_TRUE(mWorker.isSettled());
}

/// The scene on the screen may be saved, counted and drawn to a file at any time.
TEST_F(LevelWorkerCase, WhatLastsIsMadeWithTheLevelsThatAreComputed) {
  scene::Scene scene = withQuickLevels();
  TrueLevels levels;
  levels.give(scene.model, mProgress);
  EXPECT_EQ(*scene.model.levels, computed());
  scene::Scene again = withQuickLevels();
  levels.give(again.model, mProgress);
  EXPECT_EQ(again.model.levels, scene.model.levels) << "computed once";
  again.model.levels = {};
  levels.give(again.model, mProgress);
  EXPECT_FALSE(again.model.levels);
}

TEST_F(LevelWorkerCase, OnlyWhoAsksForQuickLevelsGetsThem) {
  scene::Source source;
  source.path = (mFolder / "model.cif").string();
  io::writeModel(*mModel, source.path, mProgress);
  scene::Scene quick = open(source, mProgress, {.quickLevels = true});
  ASSERT_TRUE(quick.model.levels);
  // Where no other run of this test has left its levels.
  scene::Scene whole = open(source, mProgress);
  EXPECT_FALSE(model::areQuick(*whole.model.levels));
  EXPECT_EQ(*whole.model.levels, model::computeLevels(*whole.model.data, mProgress));
  scene::Scene known = open(source, mProgress, {.quickLevels = true});
  EXPECT_EQ(*known.model.levels, *whole.model.levels) << "a file keeps them";
}

TEST_F(LevelWorkerCase, ASessionIsNotSettledBeforeTheLevelsAreThere) {
  Session session(withQuickLevels());
  EXPECT_FALSE(session.isSettled());
  EXPECT_TRUE(session.isOnItsWay());
  session.settle(mProgress);
  EXPECT_TRUE(session.isSettled());
  EXPECT_EQ(*session.scene().model.levels, computed());
  EXPECT_FALSE(session.document().isModified());
  EXPECT_FALSE(session.document().canUndo());
}

}  // namespace
}  // namespace velum::session
