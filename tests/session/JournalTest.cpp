#include "session/document/Journal.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <random>

#include "JournalFolder.h"
#include "core/Error.h"
#include "session/document/Document.h"
#include "session/document/Folders.h"
#include "session/document/Recovery.h"

namespace velum::session {

namespace fs = std::filesystem;

TEST(Journal, RandomEditsAreRecoveredExactly) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    TempFolder folder;
    std::mt19937 random(seed);
    Document document;
    {
      Journal journal(quick(folder, 2000));  // several generations
      document.setListener([&] { journal.record(document.scene(), document.undoLabel()); });
      for (int i = 0; i < 300; ++i) {
        double value = double(random() % 1000);
        switch (random() % 6) {
          case 0:
            document.undo();
            break;
          case 1:
            document.redo();
            break;
          case 2:
            document.view([&](scene::Scene& s) { s.camera.eye.x = value; });
            break;
          case 3:
            document.edit("Add cut", [&](scene::Scene& s) { s.cuts.emplace_back().centre.y = value; });
            break;
          default:
            document.edit(
                "Window", [&](scene::Scene& s) { s.volume.windowLevel = value; }, true);
        }
        if (random() % 3 == 0) journal.flush();
      }
      document.setListener({});
    }
    EXPECT_EQ(recovered(folder.path()), document.scene());
  }
}

TEST(Journal, NothingIsWrittenBeforeTheFirstChangeOrKeptAfterDiscard) {
  TempFolder folder;
  Journal journal(quick(folder));
  journal.describe("head", "");
  journal.flush();
  EXPECT_TRUE(fs::is_empty(folder.path()));
  journal.record(withLevel(1), "Window");
  journal.flush();
  EXPECT_FALSE(fs::is_empty(folder.path()));
  journal.discard();
  journal.flush();
  EXPECT_TRUE(fs::is_empty(folder.path()));
  journal.record(withLevel(2), "Window");
  journal.flush();
  EXPECT_FALSE(fs::is_empty(folder.path()));
}

TEST(Journal, LostWorkSaysWhatItWas) {
  TempFolder folder;
  {
    Journal journal(quick(folder));
    journal.describe("head.nrrd", "/scenes/head.json");
    journal.record(withLevel(1), "Window");
    journal.record(withLevel(2), "Move cut");
  }
  auto lost = findLostWork(folder.path());
  ASSERT_EQ(lost.size(), 1u);
  EXPECT_EQ(lost[0].title, "head.nrrd");
  EXPECT_EQ(lost[0].scenePath, "/scenes/head.json");
  EXPECT_EQ(lost[0].label, "Move cut");
  EXPECT_LT(std::chrono::abs(lost[0].when - std::chrono::system_clock::now()), std::chrono::minutes(1));
}

TEST(Journal, ALivingSessionIsNotOffered) {
  TempFolder folder;
  Journal journal(quick(folder));
  journal.record(withLevel(1), "Window");
  journal.flush();
  EXPECT_TRUE(findLostWork(folder.path()).empty());
  for (const auto& entry : fs::directory_iterator(folder.path())) EXPECT_THROW(WorkClaim{entry.path()}, InputError);
}

TEST(Journal, DeadWorkIsTakenByOne) {
  TempFolder folder;
  { Journal(quick(folder)).record(withLevel(1), "Window"); }
  auto lost = findLostWork(folder.path());
  ASSERT_EQ(lost.size(), 1u);
  {
    WorkClaim claim(lost[0].folder);
    EXPECT_THROW(WorkClaim{lost[0].folder}, InputError);
    EXPECT_TRUE(findLostWork(folder.path()).empty());
  }
  EXPECT_EQ(findLostWork(folder.path()).size(), 1u);
  WorkClaim(lost[0].folder).remove();
  EXPECT_TRUE(findLostWork(folder.path()).empty());
  EXPECT_THROW(WorkClaim{lost[0].folder}, InputError);
}

TEST(Journal, AKilledProcessLosesNothingThatWasFlushed) {
  TempFolder folder;
  pid_t child = ::fork();
  if (child == 0) {
    Journal journal(quick(folder));
    for (int i = 1; i <= 20; ++i) {
      journal.record(withLevel(i), "Window");
      journal.flush();
    }
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(recovered(folder.path()).volume.windowLevel, 20);
}

TEST(Journal, ATornLastLineGivesTheChangeBefore) {
  TempFolder folder;
  {
    Journal journal(quick(folder));
    for (int i = 1; i <= 5; ++i) {
      journal.record(withLevel(i), "Window");
      journal.flush();
    }
  }
  auto journals = filesIn(folder.path(), ".jsonl");
  ASSERT_EQ(journals.size(), 1u);
  auto size = fs::file_size(journals[0]);
  fs::resize_file(journals[0], size - 1);
  EXPECT_EQ(recovered(folder.path()).volume.windowLevel, 4);
}

TEST(Journal, AGrownJournalBeginsAnewAndOneBeforeIsKept) {
  TempFolder folder;
  {
    Journal journal(quick(folder, 1));  // four times the whole scene then decides
    for (int i = 1; i <= 400; ++i) {
      journal.record(withLevel(i), "Window");
      journal.flush();
    }
  }
  auto journals = filesIn(folder.path(), ".jsonl");
  EXPECT_EQ(journals.size(), 2u);
  EXPECT_EQ(filesIn(folder.path(), "autosave-").size(), 2u);
  for (const auto& path : journals) EXPECT_LT(fs::file_size(path), 100'000u);
  EXPECT_EQ(recovered(folder.path()).volume.windowLevel, 400);
}

TEST(Journal, DamageFallsBackToTheGenerationBefore) {
  TempFolder folder;
  {
    Journal journal(quick(folder, 1));
    for (int i = 1; i <= 400; ++i) {
      journal.record(withLevel(i), "Window");
      journal.flush();
    }
  }
  auto lost = findLostWork(folder.path());
  ASSERT_EQ(lost.size(), 1u);
  std::vector<fs::path> journals = filesIn(folder.path(), ".jsonl"), autosaves = filesIn(folder.path(), "autosave-");
  ASSERT_EQ(journals.size(), 2u);
  auto newest = fs::last_write_time(journals[0]) > fs::last_write_time(journals[1]) ? 0 : 1;
  // The journal alone: the autosave knows how it began. Both: the generation before.
  overwrite(journals[std::size_t(newest)], "not a journal\n");
  double fromAutosave = recovered(folder.path()).volume.windowLevel;
  overwrite(autosaves[std::size_t(newest)], "{");
  double fromBefore = recovered(folder.path()).volume.windowLevel;
  EXPECT_LT(fromAutosave, 400);
  EXPECT_EQ(fromBefore, fromAutosave - 1);
  for (const auto& path : {journals[0], journals[1], autosaves[0], autosaves[1]}) overwrite(path, "");
  EXPECT_FALSE(findLostWork(folder.path()).at(0).isReadable);
  EXPECT_THROW(WorkClaim(lost[0].folder).readScene(), InputError);
}

TEST(Journal, AFolderThatWasTidiedAwayIsMadeAgain) {
  TempFolder folder;
  {
    Journal journal(quick(folder));
    journal.record(withLevel(1), "Window");
    journal.flush();
    for (const auto& entry : fs::directory_iterator(folder.path())) fs::remove_all(entry.path());
    journal.record(withLevel(2), "Window");
  }
  EXPECT_EQ(recovered(folder.path()).volume.windowLevel, 2);
}

TEST(Journal, ADiskThatRefusesIsToldOnceAndDoesNotThrow) {
  TempFolder folder;
  overwrite(folder / "file", "");
  std::vector<std::string> said;
  {
    Journal journal({folder / "file", std::chrono::milliseconds(0)});
    journal.setErrorListener([&](const std::string& text) { said.push_back(text); });
    for (int i = 1; i <= 3; ++i) {
      journal.record(withLevel(i), "Window");
      journal.flush();
    }
  }
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("file"), std::string::npos) << said[0];
}

TEST(Journal, ADragIsAFewLines) {
  TempFolder folder;
  {
    Journal journal({folder.path(), std::chrono::milliseconds(50)});
    for (int i = 1; i <= 200; ++i) {
      journal.record(withLevel(i), "Window");
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  std::ifstream in(filesIn(folder.path(), ".jsonl").at(0));
  std::string line;
  int lines = 0;
  while (std::getline(in, line)) ++lines;
  EXPECT_LT(lines, 30);
  EXPECT_GT(lines, 2);
  EXPECT_EQ(recovered(folder.path()).volume.windowLevel, 200);
}

TEST(Journal, NoJournalHasMoreLinesOrBytesThanAreRead) {
  TempFolder folder;
  Journal::Options options = quick(folder, 100 << 20);
  options.mostLines = 10;
  options.mostBytes = 200 << 10;
  {
    Journal journal(options);
    for (int i = 1; i <= 35; ++i) {
      journal.record(withLevel(i), "Window");
      ASSERT_TRUE(journal.flush());
      for (const auto& path : filesIn(folder.path(), ".jsonl")) {
        std::ifstream in(path);
        ASSERT_LE(std::count(std::istreambuf_iterator<char>(in), {}, '\n'), 10);
      }
    }
  }
  EXPECT_EQ(recovered(folder.path()).volume.windowLevel, 35);
  fs::remove_all(findLostWork(folder.path()).at(0).folder);
  options.mostLines = 1000;
  {
    Journal journal(options);
    for (int i = 1; i <= 12; ++i) {
      scene::Scene scene;
      scene.volume.source.path = std::string(30'000, char('a' + i));
      journal.record(scene, "Open");
      ASSERT_TRUE(journal.flush());
      for (const auto& path : filesIn(folder.path(), ".jsonl")) ASSERT_LE(fs::file_size(path), options.mostBytes);
    }
  }
  EXPECT_EQ(recovered(folder.path()).volume.source.path, std::string(30'000, char('a' + 12)));
}

TEST(Journal, ASceneThatIsTooLargeIsToldAndTheNextOneIsKept) {
  TempFolder folder;
  Journal::Options options = quick(folder);
  options.mostBytes = 200 << 10;
  std::vector<std::string> said;
  {
    Journal journal(options);
    journal.setErrorListener([&](const std::string& text) { said.push_back(text); });
    journal.record(withLevel(1), "Window");
    EXPECT_TRUE(journal.flush());
    scene::Scene large = withLevel(2);
    large.volume.source.path = std::string(300 << 10, 'x');
    for (int i = 0; i < 2; ++i) {
      large.volume.windowWidth = i;
      journal.record(large, "Open");
      EXPECT_FALSE(journal.flush());
    }
    ASSERT_EQ(said.size(), 1u);
    EXPECT_NE(said[0].find("too large"), std::string::npos) << said[0];
    journal.record(withLevel(3), "Window");
    EXPECT_TRUE(journal.flush());
  }
  ASSERT_EQ(said.size(), 2u);
  EXPECT_EQ(said[1], "");
  EXPECT_EQ(recovered(folder.path()).volume.windowLevel, 3);
}

TEST(Journal, WhateverIsWrittenCanBeRead) {
  // A large scene, and as many changes of it as go into one journal: more than 64 MiB.
  TempFolder folder;
  {
    Journal journal(quick(folder));
    for (int i = 0; i < 5; ++i) {
      scene::Scene scene;
      scene.volume.source.path = std::string(15'000'000, char('a' + i));
      journal.record(scene, "Open");
      ASSERT_TRUE(journal.flush());
    }
  }
  ASSERT_EQ(filesIn(folder.path(), ".jsonl").size(), 1u);
  EXPECT_GT(fs::file_size(filesIn(folder.path(), ".jsonl")[0]), std::size_t(64) << 20);
  EXPECT_EQ(recovered(folder.path()).volume.source.path.substr(0, 3), "eee");
}

TEST(Journal, OldGenerationsGoAlsoWhereNoAutosaveCanBeWritten) {
  TempFolder folder;
  std::vector<std::string> said;
  {
    Journal journal(quick(folder, 1));
    journal.setErrorListener([&](const std::string& text) { said.push_back(text); });
    journal.record(withLevel(0), "Window");
    journal.flush();
    fs::path home = fs::directory_iterator(folder.path())->path();
    for (int i = 2; i < 50; ++i) fs::create_directories(home / ("autosave-" + std::to_string(i) + ".json") / "full");
    for (int i = 1; i <= 600; ++i) {
      journal.record(withLevel(i), "Window");
      ASSERT_TRUE(journal.flush());
    }
  }
  EXPECT_EQ(filesIn(folder.path(), ".jsonl").size(), 2u);
  EXPECT_TRUE(said.empty()) << said[0];
  EXPECT_EQ(recovered(folder.path()).volume.windowLevel, 600);
}

TEST(Folders, FollowXdgAndIgnoreWhatIsRelative) {
  std::string before = std::getenv("XDG_STATE_HOME") ? std::getenv("XDG_STATE_HOME") : "";
  ::setenv("XDG_STATE_HOME", "/somewhere", 1);
  EXPECT_EQ(recoveryFolder(), "/somewhere/velum/recovery");
  ::setenv("XDG_STATE_HOME", "relative", 1);
  EXPECT_TRUE(stateFolder().is_absolute());
  EXPECT_EQ(stateFolder().parent_path().filename(), "state");
  before.empty() ? ::unsetenv("XDG_STATE_HOME") : ::setenv("XDG_STATE_HOME", before.c_str(), 1);
}

}  // namespace velum::session
