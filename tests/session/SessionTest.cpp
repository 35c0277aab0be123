#include "session/Session.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <thread>

#include "TempFolder.h"
#include "core/Error.h"
#include "makeVolume.h"
#include "session/document/Open.h"

namespace velum::session {
namespace {

/// Collects until the job has ended.
void waitFor(Session& session) {
  while (session.isBusy()) {
    session.collect();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

TEST(Session, AJobEndsInTheThreadThatCollects) {
  Session session;
  std::atomic<int> woken{0};
  session.setWaker([&] { ++woken; });
  std::thread::id worker, ender;
  std::optional<JobOutcome> outcome;
  ASSERT_TRUE(session.startJob([&](Progress&) { worker = std::this_thread::get_id(); }, {},
                               [&](const JobOutcome& told) {
                                 ender = std::this_thread::get_id();
                                 outcome = told;
                               }));
  EXPECT_FALSE(session.startJob([](Progress&) {}, {}, {})) << "one at a time";
  waitFor(session);
  ASSERT_TRUE(outcome);
  EXPECT_TRUE(outcome->done);
  EXPECT_EQ(ender, std::this_thread::get_id());
  EXPECT_NE(worker, ender);
  EXPECT_EQ(woken, 1);
}

TEST(Session, AJobThatFailsOrIsCancelledSaysSo) {
  Session session;
  JobOutcome outcome;
  auto keep = [&](const JobOutcome& told) { outcome = told; };
  session.startJob([](Progress&) { throw InputError("no such file"); }, {}, keep);
  waitFor(session);
  EXPECT_FALSE(outcome.done);
  EXPECT_EQ(outcome.error, "no such file");
  session.startJob(
      [](Progress& progress) {
        for (;;) progress.report(0.5, "on and on");
      },
      {}, keep);
  session.cancelJob();
  waitFor(session);
  EXPECT_FALSE(outcome.done);
  EXPECT_TRUE(outcome.error.empty());
}

TEST(Session, GoneItHasCancelledAndAwaitedItsJob) {
  std::atomic<bool> ended{false};
  {
    Session session;
    session.startJob(
        [&](Progress& progress) {
          try {
            for (;;) progress.report(0.5, "on and on");
          } catch (const Cancelled&) {
            ended = true;
            throw;
          }
        },
        {}, [](const JobOutcome&) { FAIL() << "nobody is there to hear it"; });
  }
  EXPECT_TRUE(ended);
}

TEST(Session, ASceneThatCouldNotBeOpenedAgainIsNotWritten) {
  TempFolder folder;
  scene::Scene scene;
  scene.volume.source.path = std::string(65 << 20, 'x');
  EXPECT_THROW(saveScene(scene, folder / "a.json"), InputError);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Session, ItsJournalGoesWithSavingAndComesWithTheNextChange) {
  TempFolder folder;
  Session session;
  auto root = folder / "recovery";
  auto folders = [&] {
    std::error_code none;
    auto all = std::filesystem::directory_iterator(root, none);
    return none ? 0 : int(std::distance(begin(all), end(all)));
  };
  session.file().protect(root, [](const std::string& text) { ADD_FAILURE() << text; });
  Loaded loaded;
  loaded.scene.background.top = {0, 0, 0};
  session.file().open(std::move(loaded), "nothing much");
  session.file().discardJournal(true);
  EXPECT_EQ(folders(), 0) << "what was opened is safe where it came from";
  int told = 0;
  session.setListener([&] { ++told; });
  session.document().edit("Change", [](scene::Scene& scene) { scene.background.top = {1, 0, 0}; });
  EXPECT_EQ(told, 1);
  EXPECT_TRUE(session.file().isModified());
  for (int i = 0; i < 2000 && folders() == 0; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(folders(), 1);
  session.file().save((folder / "a.json").string());
  EXPECT_FALSE(session.file().isModified());
  EXPECT_EQ(session.file().name(), "a.json");
  session.file().discardJournal(true);
  EXPECT_EQ(folders(), 0);
}

TEST(Session, WhatIsOpenHasANameAndMayHaveAFile) {
  TempFolder folder;
  Session session;
  EXPECT_FALSE(session.file().isOpen());
  session.file().open({}, "torso");
  EXPECT_EQ(session.file().path(), "torso");
  EXPECT_TRUE(session.file().scenePath().empty());
  auto path = (folder / "Scene.JSON").string();
  session.file().open({}, path);
  EXPECT_EQ(session.file().scenePath(), path);
  session.file().close();
  EXPECT_TRUE(session.file().path().empty());
  EXPECT_FALSE(session.file().isModified());
}

}  // namespace
}  // namespace velum::session
