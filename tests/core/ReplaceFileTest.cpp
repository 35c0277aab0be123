#include "core/ReplaceFile.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "SmallDisk.h"
#include "TempFolder.h"
#include "core/Error.h"

namespace velum {
namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::ptrdiff_t filesIn(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

TEST(ReplaceFile, ACommitReplacesTheWhole) {
  TempFolder folder;
  replaceFile(folder / "a.txt", "a long text that was there");
  ReplaceFile file(folder / "a.txt");
  file.write("new ");
  file.write("text");
  EXPECT_EQ(textOf(folder / "a.txt"), "a long text that was there");
  file.commit();
  EXPECT_EQ(textOf(folder / "a.txt"), "new text");
  EXPECT_EQ(filesIn(folder.path()), 1);
}

TEST(ReplaceFile, WithoutACommitNothingHasHappened) {
  TempFolder folder;
  replaceFile(folder / "a.txt", "old");
  {
    ReplaceFile file(folder / "a.txt");
    file.write("half of the new");
    EXPECT_EQ(filesIn(folder.path()), 2);
  }
  EXPECT_EQ(textOf(folder / "a.txt"), "old");
  EXPECT_EQ(filesIn(folder.path()), 1);
}

TEST(ReplaceFile, AFullDiskLeavesTheOldFileAndSaysWhich) {
  TempFolder folder;
  replaceFile(folder / "a.txt", "old");
  SmallDisk disk(10000);
  try {
    replaceFile(folder / "a.txt", std::string(20000, 'x'));
    FAIL() << "20000 bytes went onto a disk of 10000";
  } catch (const InputError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with((folder / "a.txt").string() + ": cannot be written"))
        << error.what();
  }
  EXPECT_EQ(textOf(folder / "a.txt"), "old");
  EXPECT_EQ(filesIn(folder.path()), 1);
}

TEST(ReplaceFile, WhereNothingCanBeWrittenIsSaidAtOnce) {
  TempFolder folder;
  EXPECT_THROW(ReplaceFile(folder / "missing" / "a.txt"), InputError);
  EXPECT_THROW(ReplaceFile(folder.path()), InputError);
  EXPECT_THROW(expectReplaceable(folder / "missing" / "a.txt"), InputError);
  EXPECT_THROW(expectReplaceable(folder.path()), InputError);
  EXPECT_NO_THROW(expectReplaceable(folder / "a.txt"));
  EXPECT_EQ(filesIn(folder.path()), 0);
}

TEST(ReplaceFile, ANameMayBeAsLongAsTheDiskAllows) {
  TempFolder folder;
  std::string name = std::string(248, 'n') + ".nii.gz";
  replaceFile(folder / name, "text");
  EXPECT_EQ(textOf(folder / name), "text");
}

TEST(ReplaceFile, TwoOfOneTargetDoNotMeet) {
  TempFolder folder;
  ReplaceFile first(folder / "a.txt"), second(folder / "a.txt");
  first.write("first");
  second.write("second");
  second.commit();
  first.commit();
  EXPECT_EQ(textOf(folder / "a.txt"), "first");
}

TEST(ReplaceFile, AnOwnersFileIsNobodyElses) {
  TempFolder folder;
  replaceFile(folder / "a.txt", "mine", ReplaceFile::Access::Owner);
  struct stat state {};
  ASSERT_EQ(::stat((folder / "a.txt").c_str(), &state), 0);
  EXPECT_EQ(state.st_mode & 0777, 0600u);
}

TEST(ReplaceFile, TheCallerMayWriteOn) {
  TempFolder folder;
  ReplaceFile file(folder / "a.txt");
  file.write("one");
  file.commit(ReplaceFile::Sync::ByCaller);
  int descriptor = file.releaseDescriptor();
  EXPECT_TRUE(writeAll(descriptor, std::as_bytes(std::span(" two", 4))));
  ::close(descriptor);
  EXPECT_EQ(textOf(folder / "a.txt"), "one two");
}

TEST(ReplaceFile, WhatTheDiskRefusedOnceIsNeverCommitted) {
  TempFolder folder;
  replaceFile(folder / "a.txt", "old");
  SmallDisk disk(10);
  ReplaceFile file(folder / "a.txt");
  std::string text(20, 'x');
  EXPECT_FALSE(file.writeAt(0, std::as_bytes(std::span(text))));
  EXPECT_FALSE(file.writeAt(0, std::as_bytes(std::span(text).first(1)))) << "one that does not look goes on";
  EXPECT_THROW(file.commit(), InputError);
  EXPECT_EQ(textOf(folder / "a.txt"), "old");
}

TEST(ReplaceFile, AWriterMayGoBack) {
  TempFolder folder;
  ReplaceFile file(folder / "a.txt");
  std::string text = "abcdef";
  EXPECT_TRUE(file.writeAt(0, std::as_bytes(std::span(text))));
  EXPECT_TRUE(file.writeAt(2, std::as_bytes(std::span(text).first(2))));
  file.commit();
  EXPECT_EQ(textOf(folder / "a.txt"), "ababef");
}

TEST(ReplaceFile, ThroughALinkItsTargetIsWritten) {
  TempFolder folder;
  fs::create_directory(folder / "data");
  replaceFile(folder / "data" / "a.txt", "old");
  fs::create_symlink("data/a.txt", folder / "one");
  fs::create_symlink(folder / "one", folder / "two");
  replaceFile(folder / "two", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "two"));
  EXPECT_EQ(textOf(folder / "data" / "a.txt"), "new");
  fs::create_symlink("data/b.txt", folder / "open");
  replaceFile(folder / "open", "made");
  EXPECT_EQ(textOf(folder / "data" / "b.txt"), "made");
  fs::create_symlink("round", folder / "round");
  EXPECT_THROW(replaceFile(folder / "round", "never"), InputError);
}

TEST(ReplaceFile, ModeAndOwnerAreKept) {
  TempFolder folder;
  replaceFile(folder / "a.txt", "old");
  ASSERT_EQ(::chmod((folder / "a.txt").c_str(), 0640), 0);
  // Only an administrator can give a file away; without one the mode alone is tried.
  bool gave = ::chown((folder / "a.txt").c_str(), 4711, 4712) == 0;
  replaceFile(folder / "a.txt", "new");
  struct stat state {};
  ASSERT_EQ(::stat((folder / "a.txt").c_str(), &state), 0);
  EXPECT_EQ(state.st_mode & 07777, 0640u);
  EXPECT_EQ(state.st_uid, gave ? 4711u : ::geteuid());
  EXPECT_EQ(state.st_gid, gave ? 4712u : ::getegid());
}

TEST(ReplaceFile, AReadOnlyFileAndWhatIsNoFileAreRefused) {
  TempFolder folder;
  replaceFile(folder / "a.txt", "old");
  ASSERT_EQ(::chmod((folder / "a.txt").c_str(), 0444), 0);
  EXPECT_THROW(replaceFile(folder / "a.txt", "new"), InputError);
  EXPECT_EQ(textOf(folder / "a.txt"), "old");
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_THROW(replaceFile(folder / "pipe", "new"), InputError);
  EXPECT_THROW(replaceFile("/dev/full", "new"), InputError);
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
  EXPECT_EQ(filesIn(folder.path()), 2);
}

/// A process that is killed while it writes.
void dieWriting(const fs::path& target) {
  pid_t child = ::fork();
  if (child == 0) {
    ReplaceFile file(target);
    file.write("half of the new");
    ::raise(SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
}

TEST(ReplaceFile, WhatKilledRunsLeftIsRemovedByTheNext) {
  TempFolder folder;
  dieWriting(folder / "a.txt");
  EXPECT_EQ(filesIn(folder.path()), 1);
  std::ofstream(folder / ".velum-notes") << "a user's";
  replaceFile(folder / "b.txt", "text");
  EXPECT_EQ(filesIn(folder.path()), 2) << "the user's and the new one";
}

TEST(ReplaceFile, WhatALivingProcessWritesIsNotRemoved) {
  TempFolder folder;
  ReplaceFile file(folder / "a.txt");
  file.write("text");
  pid_t child = ::fork();
  if (child == 0) {
    // Another folder's name for the same: this process looked through the first already.
    replaceFile(folder / "." / "b.txt", "from another");
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  file.commit();
  EXPECT_EQ(textOf(folder / "a.txt"), "text");
  EXPECT_EQ(textOf(folder / "b.txt"), "from another");
}

TEST(ReplaceFile, NamesOfTemporariesCannotBeGuessed) {
  TempFolder folder;
  std::vector<std::string> names;
  for (int i = 0; i < 50; ++i) {
    ReplaceFile file(folder / "a.txt");
    names.push_back(fs::directory_iterator(folder.path())->path().filename().string());
  }
  // Of 50 random digits hardly ever fewer than 5 differ; of a count or the number of a process most do not.
  int changing = 0;
  for (std::size_t place = 0; place < names[0].size(); ++place) {
    std::set<char> seen;
    for (const std::string& name : names) seen.insert(name.at(place));
    changing += seen.size() >= 5;
  }
  EXPECT_EQ(changing, 16) << "64 bits in hexadecimal digits, as in " << names[0];
}

}  // namespace
}  // namespace velum
