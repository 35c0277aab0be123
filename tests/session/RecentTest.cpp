#include "session/document/Recent.h"

#include <gtest/gtest.h>

#include <fstream>

#include "TempFolder.h"

namespace velum::session {

TEST(Recent, TheNewestComesFirstAndEachOnce) {
  TempFolder folder;
  auto list = folder / "state/velum/recent";
  EXPECT_TRUE(readRecent(list).empty());
  for (const char* path : {"/a/1.json", "/a/2 with space.json", "/b/3.json", "/a/1.json"}) addRecent(list, path);
  auto files = readRecent(list);
  ASSERT_EQ(files.size(), 3u);
  EXPECT_EQ(files[0].path, "/a/1.json");
  EXPECT_EQ(files[2].path, "/a/2 with space.json");
  EXPECT_EQ(recentFolders(list), (std::vector<std::filesystem::path>{"/a", "/b"}));
  removeRecent(list, "/b/3.json");
  EXPECT_EQ(readRecent(list).size(), 2u);
}

TEST(Recent, IsBounded) {
  TempFolder folder;
  for (std::size_t i = 0; i < kMostRecent + 5; ++i) addRecent(folder / "recent", "/a/" + std::to_string(i));
  EXPECT_EQ(readRecent(folder / "recent").size(), kMostRecent);
}

TEST(Recent, NonsenseIsLeftOut) {
  TempFolder folder;
  std::ofstream(folder / "recent")
      << "\n17\t/good\nx\t/bad\n18\trelative\n19 /bad\n99999999999999999999\t/bad\n-4\t/bad\n20\t\n";
  auto files = readRecent(folder / "recent");
  ASSERT_EQ(files.size(), 1u);
  EXPECT_EQ(files[0].path, "/good");
  addRecent(folder / "recent", "relative");
  addRecent(folder / "recent", "/two\nlines");
  EXPECT_EQ(readRecent(folder / "recent").size(), 1u);
}

}  // namespace velum::session
