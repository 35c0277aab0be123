#pragma once
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "TempFolder.h"
#include "session/document/Journal.h"
#include "session/document/Recovery.h"

/// What tests of journals and of recovery share.
namespace velum::session {

inline Journal::Options quick(const TempFolder& folder, std::size_t compactBytes = 256 << 10) {
  return {folder.path(), std::chrono::milliseconds(0), compactBytes};
}

inline scene::Scene withLevel(double level) {
  scene::Scene scene;
  scene.volume.windowLevel = level;
  return scene;
}

inline std::vector<std::filesystem::path> filesIn(const std::filesystem::path& folder, const std::string& part) {
  std::vector<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.path().filename().string().find(part) != std::string::npos) found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

inline scene::Scene recovered(const std::filesystem::path& root) {
  auto lost = findLostWork(root);
  if (lost.size() != 1) throw std::runtime_error(std::to_string(lost.size()) + " sessions have died");
  return WorkClaim(lost[0].folder).readScene();
}

inline void overwrite(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << text;
}

/// A session that has died. @return its folder
inline std::filesystem::path leaveWork(const TempFolder& root, double level) {
  std::vector<std::filesystem::path> before;
  for (const auto& entry : std::filesystem::directory_iterator(root.path())) before.push_back(entry.path());
  {
    Journal journal(quick(root));
    journal.describe("head.nrrd", "/a/head.json");
    journal.record(withLevel(level), "Window");
  }
  for (const auto& entry : std::filesystem::directory_iterator(root.path()))
    if (std::find(before.begin(), before.end(), entry.path()) == before.end()) return entry.path();
  return {};
}

}  // namespace velum::session
