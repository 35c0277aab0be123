// A disk that takes no more, and takes it again. A limit of the size of files stands in for one; where this may mount,
// a real one is tried, too.
#include <gtest/gtest.h>
#include <sys/mount.h>

#include <thread>

#include "JournalFolder.h"
#include "SmallDisk.h"
#include "core/Error.h"
#include "scene/json/ChangeLog.h"
#include "session/Session.h"
#include "session/document/Open.h"

namespace velum::session {

namespace fs = std::filesystem;

namespace {

/// What the journal of a session tells.
struct Told {
  std::mutex mutex;
  std::vector<std::string> lines;
  void add(const std::string& text) {
    std::lock_guard guard(mutex);
    lines.push_back(text);
  }
  std::vector<std::string> all() {
    std::lock_guard guard(mutex);
    return lines;
  }
  bool waitFor(std::size_t count) {
    for (int i = 0; i < 1000 && all().size() < count; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return all().size() >= count;
  }
};

/// What would be found had the session just died: of a copy, as it lives.
LostWork afterACrash(const fs::path& root, scene::Scene& scene) {
  TempFolder copy;
  fs::copy(root, copy.path(), fs::copy_options::recursive);
  auto lost = findLostWork(copy.path());
  if (lost.size() != 1) throw std::runtime_error(std::to_string(lost.size()) + " sessions");
  scene = WorkClaim(lost[0].folder).readScene();
  return lost[0];
}

/// A change that does not fit into what is left of a page.
scene::Scene largeWithLevel(double level) {
  scene::Scene scene = withLevel(level);
  scene.volume.source.path = std::string(20'000, char('a' + int(level) % 20));
  return scene;
}

/// The law itself. @param fill  makes the disk full  @param clear  makes room
void expectWholeAgain(const fs::path& root, const std::function<void()>& fill, const std::function<void()>& clear) {
  Told told;
  Journal::Options options{root, std::chrono::milliseconds(0)};
  options.retry = std::chrono::milliseconds(50);
  Journal journal(options);
  journal.setErrorListener([&](const std::string& text) { told.add(text); });
  journal.record(withLevel(1), "Window");
  ASSERT_TRUE(journal.flush());
  scene::Scene found;
  for (int round = 1; round <= 3; ++round) {
    fill();
    bool taken = true;
    for (int i = 1; i <= 3; ++i) {
      journal.record(largeWithLevel(10 * round + i), "Window");
      taken = journal.flush();
    }
    EXPECT_FALSE(taken);
    std::this_thread::sleep_for(std::chrono::milliseconds(300));  // it goes on trying, and says no more
    EXPECT_EQ(told.all().size(), std::size_t(2 * round - 1));
    ASSERT_FALSE(told.all().empty());
    EXPECT_FALSE(told.all().back().empty());
    clear();
    // Without another change.
    ASSERT_TRUE(told.waitFor(std::size_t(2 * round)));
    EXPECT_EQ(told.all().back(), "");
    EXPECT_TRUE(journal.flush());
    EXPECT_TRUE(afterACrash(root, found).isWhole);
    EXPECT_EQ(found.volume.windowLevel, 10 * round + 3);
  }
}

}  // namespace

TEST(FullDisk, IsSaidOnceAndTheJournalIsWholeWhenThereIsRoomAgain) {
  TempFolder folder;
  std::optional<SmallDisk> disk;
  expectWholeAgain(
      folder.path(), [&] { disk.emplace(100); }, [&] { disk.reset(); });
}

TEST(FullDisk, OfARealFileSystemIsSurvived) {
  TempFolder folder;
  if (::mount("none", folder.path().c_str(), "tmpfs", 0, "size=256k") != 0) GTEST_SKIP() << "this may not mount";
  expectWholeAgain(
      folder.path() / "recovery",
      [&] {
        std::ofstream out(folder / "filler", std::ios::binary);
        for (int i = 0; i < 1000 && out; ++i) out << std::string(1000, 'x') << std::flush;
      },
      [&] { fs::remove(folder / "filler"); });
  EXPECT_EQ(::umount2(folder.path().c_str(), MNT_DETACH), 0);
}

TEST(FullDisk, HalfALineLeavesWhatWasBeforeIt) {
  TempFolder folder;
  Journal::Options options{folder.path()};
  options.retry = std::chrono::hours(1);  // a second try would take a new file
  Told told;
  Journal journal(options);
  journal.setErrorListener([&](const std::string& text) { told.add(text); });
  journal.record(withLevel(1), "Window");
  ASSERT_TRUE(journal.flush());
  scene::Scene found;
  EXPECT_TRUE(afterACrash(folder.path(), found).isWhole);
  {
    SmallDisk disk(fs::file_size(filesIn(folder.path(), ".jsonl").at(0)) + 20);
    journal.record(withLevel(2), "Window");
    EXPECT_TRUE(told.waitFor(1));
  }
  LostWork work = afterACrash(folder.path(), found);
  EXPECT_EQ(found.volume.windowLevel, 1);
  EXPECT_TRUE(work.isReadable);
  EXPECT_FALSE(work.isWhole);
  EXPECT_NE(work.whyNot.find("journal-1.jsonl"), std::string::npos) << work.whyNot;
}

TEST(FullDisk, BeforeTheFirstLineLeavesNoFolders) {
  TempFolder folder;
  Journal::Options options = quick(folder);
  options.retry = std::chrono::milliseconds(5);
  {
    SmallDisk disk(100);
    Journal journal(options);
    for (int i = 0; i < 5; ++i) {
      journal.record(withLevel(i), "Window");
      EXPECT_FALSE(journal.flush());
    }
    EXPECT_LE(std::distance(fs::directory_iterator(folder.path()), {}), 1);
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(FullDisk, WorkThatIsRestoredStaysUntilItIsSafe) {
  TempFolder folder;
  fs::path old = leaveWork(folder, 5);
  {
    SmallDisk disk(100);
    Session session;
    session.file().protect(folder.path(), [](const std::string&) {});
    Loaded loaded;
    loaded.lost = std::make_unique<WorkClaim>(old);
    loaded.scene = loaded.lost->readScene();
    session.file().open(std::move(loaded), "head.nrrd");
    EXPECT_TRUE(fs::exists(old));
    EXPECT_THROW(WorkClaim{old}, InputError) << "nobody else takes it meanwhile";
  }
  EXPECT_EQ(recovered(folder.path()).volume.windowLevel, 5);
  // Saved, it goes.
  Session session;
  session.file().protect(folder.path(), [](const std::string&) {});
  {
    SmallDisk disk(100);
    Loaded loaded;
    loaded.lost = std::make_unique<WorkClaim>(old);
    loaded.scene = loaded.lost->readScene();
    session.file().open(std::move(loaded), "head.nrrd");
  }
  session.file().save((folder / "saved.json").string());
  session.file().discardJournal(true);
  EXPECT_FALSE(fs::exists(old));
}

TEST(FullDisk, ASceneThatIsNotSavedStaysModifiedAndTheOldFileWhole) {
  TempFolder folder;
  Session session;
  Loaded loaded;
  loaded.scene = withLevel(1);
  session.file().open(std::move(loaded), "head.nrrd");
  session.file().save((folder / "a.json").string());
  session.document().edit("Window", [](scene::Scene& scene) { scene.volume.windowLevel = 2; });
  {
    SmallDisk disk(100);
    EXPECT_THROW(session.file().save((folder / "a.json").string()), InputError);
  }
  EXPECT_TRUE(session.file().isModified());
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1) << "and no temporary";
  EXPECT_EQ(readSceneText((folder / "a.json").string())->find("\"windowLevel\": 1") != std::string::npos, true);
}

}  // namespace velum::session
