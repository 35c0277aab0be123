#pragma once
#include <chrono>
#include <filesystem>
#include <vector>

/// The files that were opened or saved last: a small text file, shared by all windows.
namespace velum::session {

struct RecentFile {
  std::filesystem::path path;  ///< absolute
  std::chrono::system_clock::time_point when;
};

constexpr std::size_t kMostRecent = 24;

/// Newest first. Lines that make no sense are left out; empty when there is no list.
std::vector<RecentFile> readRecent(const std::filesystem::path& list);
/// Puts a file in front. A disk that refuses is no error: the list is a convenience.
void addRecent(const std::filesystem::path& list, const std::filesystem::path& file);
/// Takes a file off the list.
void removeRecent(const std::filesystem::path& list, const std::filesystem::path& file);

/// Where the list is: stateFolder()/recent.
std::filesystem::path recentList();
/// Where the small picture of a recent file belongs: cacheFolder()/recent/HASH.png.
std::filesystem::path recentPicture(const std::filesystem::path& file);
/// The folders of recent files, each once: places to look for data that has moved.
std::vector<std::filesystem::path> recentFolders(const std::filesystem::path& list);

}  // namespace velum::session
