// When a session's last change was: that of its journal, whatever is older beside it.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "TempFolder.h"
#include "session/document/Journal.h"
#include "session/document/Recovery.h"

namespace velum::session {
namespace {

namespace fs = std::filesystem;

/// A session that has died with work of its own. @return its folder
fs::path die(const TempFolder& root, const std::string& title) {
  auto before = findLostWork(root.path());
  {
    Journal journal({root.path(), std::chrono::milliseconds(0), 256 << 10});
    journal.describe(title, "");
    scene::Scene scene;
    scene.volume.windowLevel = 1.0;
    journal.record(scene, "Window");
  }
  for (const LostWork& work : findLostWork(root.path()))
    if (std::none_of(before.begin(), before.end(), [&](const auto& b) { return b.folder == work.folder; }))
      return work.folder;
  ADD_FAILURE() << "nothing was lost";
  return {};
}

/// As if its last change had been so long ago.
void age(const fs::path& folder, std::chrono::minutes minutes) {
  for (const auto& entry : fs::directory_iterator(folder))
    fs::last_write_time(entry.path(), fs::file_time_type::clock::now() - minutes);
}

TEST(LostWork, AChangeMakesOldWorkTheNewest) {
  TempFolder root;
  fs::path old = die(root, "old"), newer = die(root, "newer");
  age(old, std::chrono::minutes(60));
  age(newer, std::chrono::minutes(10));
  ASSERT_EQ(findLostWork(root.path()).at(0).title, "newer");
  // The journal alone is written with every change; the autosave beside it is older.
  for (const auto& entry : fs::directory_iterator(old))
    if (entry.path().filename().string().find("journal") != std::string::npos)
      fs::last_write_time(entry.path(), fs::file_time_type::clock::now());
  auto lost = findLostWork(root.path());
  ASSERT_EQ(lost.size(), 2u);
  EXPECT_EQ(lost[0].title, "old");
  EXPECT_LT(std::chrono::abs(lost[0].when - std::chrono::system_clock::now()), std::chrono::minutes(1));
}

}  // namespace
}  // namespace velum::session
