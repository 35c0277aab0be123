#include "velum/core/ReplaceFile.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <iterator>

#include "TempFolder.h"
#include "velum/core/Error.h"

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

/// While one lives, the system takes only so many bytes of a file: a disk that fills up.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) : mHandler(::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &mLimit);
    rlimit small{bytes, mLimit.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() {
    ::setrlimit(RLIMIT_FSIZE, &mLimit);
    ::signal(SIGXFSZ, mHandler);
  }

 private:
  rlimit mLimit{};
  void (*mHandler)(int);
};

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
  EXPECT_EQ(filesIn(folder.path()), 0);
}

TEST(ReplaceFile, ANameMayBeAsLongAsTheDiskAllows) {
  TempFolder folder;
  std::string name = std::string(248, 'n') + ".nii.gz";
  EXPECT_TRUE(ReplaceFile(folder / name).temporary().string().ends_with("n.nii.gz"));
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

TEST(ReplaceFile, WhatALibraryWritesByNameIsCommitted) {
  TempFolder folder;
  ReplaceFile file(folder / "a.txt");
  std::ofstream(file.temporary()) << "by name";
  file.commit();
  EXPECT_EQ(textOf(folder / "a.txt"), "by name");
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

}  // namespace
}  // namespace velum
