#include "session/document/Recovery.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>

#include "JournalFolder.h"
#include "core/Error.h"

namespace velum::session {

namespace fs = std::filesystem;

namespace {

constexpr uid_t kNobody = 65534;

/// In a process of a user who owns nothing here. @return true when the work says so
bool asAStranger(const std::function<bool()>& work) {
  pid_t child = ::fork();
  if (child == 0) {
    bool isStranger = ::geteuid() != 0 || ::seteuid(kNobody) == 0;
    bool said = false;
    try {
      said = isStranger && work();
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s\n", error.what());
    }
    ::_exit(said ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

void setTime(const fs::path& folder, int hour) {
  for (const auto& entry : fs::directory_iterator(folder))
    fs::last_write_time(entry.path(), fs::file_time_type::clock::now() - std::chrono::hours(hour));
}

std::string refusalOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST(Recovery, WorkWithoutALockIsListedTakenByOneAndRemoved) {
  TempFolder root;
  fs::path folder = leaveWork(root, 5);
  fs::remove(folder / "lock");
  auto lost = findLostWork(root.path());
  ASSERT_EQ(lost.size(), 1u);
  EXPECT_TRUE(lost[0].isReadable);
  EXPECT_EQ(lost[0].title, "head.nrrd");
  WorkClaim claim(folder);
  EXPECT_THROW(WorkClaim{folder}, InputError);
  EXPECT_TRUE(findLostWork(root.path()).empty()) << "somebody has it";
  EXPECT_EQ(claim.readScene().volume.windowLevel, 5);
  claim.remove();
  EXPECT_TRUE(fs::is_empty(root.path()));
}

TEST(Recovery, TheNewestComesFirst) {
  TempFolder root;
  std::vector<fs::path> folders;
  for (int i = 0; i < 4; ++i) folders.push_back(leaveWork(root, i));
  const int hours[] = {2, 9, 1, 5};
  for (int i = 0; i < 4; ++i) setTime(folders[std::size_t(i)], hours[i]);
  overwrite(folders[3] / "journal-1.jsonl", "");
  fs::remove(folders[3] / "autosave-1.json");
  setTime(folders[3], 5);
  auto lost = findLostWork(root.path());
  ASSERT_EQ(lost.size(), 4u);
  for (int place = 0; const int which : {2, 0, 3, 1})
    EXPECT_EQ(lost[std::size_t(place++)].folder, folders[std::size_t(which)]);
  // Where two are of one time, the session that began later.
  auto when = fs::file_time_type::clock::now() - std::chrono::hours(1);
  for (const auto& folder : folders)
    for (const auto& entry : fs::directory_iterator(folder)) fs::last_write_time(entry.path(), when);
  lost = findLostWork(root.path());
  for (std::size_t i = 1; i < 4; ++i) EXPECT_GT(lost[i - 1].folder, lost[i].folder);
}

TEST(Recovery, WhatCannotBeReadIsListedWithTheFileAndWhy) {
  struct Case {
    std::function<void(const fs::path&)> damage;
    const char* words;
  };
  const Case cases[] = {
      {[](const fs::path& folder) { overwrite(folder / "journal-1.jsonl", "{}\n"); }, "journal-1.jsonl: it is damaged"},
      {[](const fs::path& folder) {
         fs::remove(folder / "journal-1.jsonl");
         fs::create_directory(folder / "journal-1.jsonl");
       },
       "journal-1.jsonl: it is no file"},
      {[](const fs::path& folder) {
         fs::remove(folder / "journal-1.jsonl");
         ::mkfifo((folder / "journal-1.jsonl").c_str(), 0600);
       },
       "journal-1.jsonl: it is no file"},
      {[](const fs::path& folder) {
         fs::remove(folder / "journal-1.jsonl");
         overwrite(folder / "notes.txt", "of somebody");
       },
       "no journal is in it"},
      {[](const fs::path& folder) {
         fs::remove_all(folder);
         overwrite(folder, "a file");
       },
       "Not a directory"},
  };
  for (const auto& [damage, words] : cases) {
    TempFolder root;
    fs::path folder = leaveWork(root, 5);
    fs::remove(folder / "autosave-1.json");
    damage(folder);
    auto lost = findLostWork(root.path());
    ASSERT_EQ(lost.size(), 1u) << words;
    EXPECT_FALSE(lost[0].isReadable);
    EXPECT_EQ(lost[0].folder, folder);
    EXPECT_NE(lost[0].whyNot.find(words), std::string::npos) << lost[0].whyNot;
    WorkClaim claim(folder);
    std::string refusal = refusalOf([&] { claim.readScene(); });
    EXPECT_NE(refusal.find(folder.string()), std::string::npos) << refusal;
    EXPECT_NE(refusal.find(words), std::string::npos) << refusal;
    claim.remove();
    EXPECT_TRUE(fs::is_empty(root.path())) << words;
  }
}

TEST(Recovery, AnAutosaveThatCannotBeReadBesideAWholeJournalCostsNothing) {
  TempFolder root;
  fs::path folder = leaveWork(root, 5);
  fs::remove(folder / "autosave-1.json");
  fs::create_directory(folder / "autosave-1.json");
  auto lost = findLostWork(root.path());
  ASSERT_EQ(lost.size(), 1u);
  EXPECT_TRUE(lost[0].isReadable && lost[0].isWhole) << lost[0].whyNot;
  EXPECT_EQ(recovered(root.path()).volume.windowLevel, 5);
}

TEST(Recovery, AnOlderGenerationIsGivenAndSaidToBeOlder) {
  TempFolder root;
  fs::path folder = leaveWork(root, 5);
  fs::create_directory(folder / "journal-2.jsonl");
  overwrite(folder / "autosave-2.json", "{");
  auto lost = findLostWork(root.path());
  ASSERT_EQ(lost.size(), 1u);
  EXPECT_TRUE(lost[0].isReadable);
  EXPECT_FALSE(lost[0].isWhole);
  EXPECT_NE(lost[0].whyNot.find("journal-2.jsonl"), std::string::npos) << lost[0].whyNot;
  EXPECT_EQ(recovered(root.path()).volume.windowLevel, 5);
}

TEST(Recovery, ASessionThatDiedBeforeItsFolderHadItsNameIsListed) {
  TempFolder root;
  fs::path folder = leaveWork(root, 5);
  fs::rename(folder, root / ("." + folder.filename().string()));
  fs::create_directory(root / ".1-2-3");
  overwrite(root / ".1-2-3" / "lock", "");
  EXPECT_EQ(recovered(root.path()).volume.windowLevel, 5);
  EXPECT_TRUE(fs::exists(root / ".1-2-3")) << "it may just be being made";
}

TEST(Recovery, WhatIsEmptyIsNoWorkAndWhatWasBeingDeletedIs) {
  TempFolder root;
  for (const char* name : {"1-2-3", ".1-2-4", ".gone-1-2-5"}) {
    fs::create_directory(root / name);
    overwrite(root / name / "lock", "");
    fs::last_write_time(root / name, fs::file_time_type::clock::now() - std::chrono::hours(2));
  }
  overwrite(root / ".gone-1-2-5" / "journal-1.jsonl", "");
  EXPECT_TRUE(findLostWork(root.path()).empty());
  EXPECT_TRUE(fs::is_empty(root.path()));
}

TEST(Recovery, AFolderOfAllWorkThatCannotBeReadIsAnError) {
  TempFolder root;
  overwrite(root / "recovery", "a file");
  std::string refusal = refusalOf([&] { findLostWork(root / "recovery"); });
  EXPECT_NE(refusal.find((root / "recovery").string()), std::string::npos);
  EXPECT_NE(refusal.find("Not a directory"), std::string::npos) << refusal;
  EXPECT_TRUE(findLostWork(root / "none").empty());
}

TEST(Recovery, WhatMayNotBeReadIsListedAndSaid) {
  TempFolder root;
  fs::path folder = leaveWork(root, 5);
  auto isSaid = [&] {
    auto lost = findLostWork(root.path());
    return lost.size() == 1 && !lost[0].isReadable && lost[0].folder == folder &&
           lost[0].whyNot.find("Permission denied") != std::string::npos;
  };
  fs::permissions(folder, fs::perms::none);
  EXPECT_TRUE(asAStranger(isSaid)) << "the folder";
  fs::permissions(folder, fs::perms::all);
  fs::permissions(folder / "lock", fs::perms::none);
  EXPECT_TRUE(asAStranger(isSaid)) << "its lock";
  fs::permissions(folder / "lock", fs::perms::all);
  for (const char* name : {"journal-1.jsonl", "autosave-1.json"}) fs::permissions(folder / name, fs::perms::none);
  EXPECT_TRUE(asAStranger(isSaid)) << "its files";
  fs::permissions(root.path(), fs::perms::none);
  EXPECT_TRUE(asAStranger([&] {
    return refusalOf([&] { findLostWork(root.path()); }).find("Permission denied") != std::string::npos;
  })) << "the folder of all";
  fs::permissions(root.path(), fs::perms::owner_all);
}

TEST(Recovery, WhatCannotBeDeletedIsSaidAndStays) {
  TempFolder root;
  fs::path folder = leaveWork(root, 5);
  fs::perms readable = fs::perms(0755);
  fs::permissions(folder, readable);
  for (const auto& entry : fs::directory_iterator(folder)) fs::permissions(entry.path(), readable);
  EXPECT_TRUE(asAStranger([&] {
                WorkClaim claim(folder);
                return refusalOf([&] { claim.remove(); }).find("cannot be deleted") != std::string::npos;
              }) ||
              ::geteuid() != 0);
  EXPECT_TRUE(::geteuid() != 0 || recovered(root.path()).volume.windowLevel == 5);
}

}  // namespace velum::session
