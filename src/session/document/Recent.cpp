#include "session/document/Recent.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <string>

#include "core/Error.h"
#include "core/ReplaceFile.h"
#include "session/document/Folders.h"
#include "session/document/JournalFiles.h"

namespace velum::session {

namespace fs = std::filesystem;
using std::chrono::seconds;
using std::chrono::system_clock;

namespace {

void write(const fs::path& list, const std::vector<RecentFile>& files) {
  std::string text;
  for (const auto& file : files)
    text += fmt::format("{}\t{}\n", std::chrono::duration_cast<seconds>(file.when.time_since_epoch()).count(),
                        file.path.string());
  std::error_code ignored;
  fs::create_directories(list.parent_path(), ignored);
  try {
    replaceFile(list, text, ReplaceFile::Access::Owner);
  } catch (const Error&) {
  }
}

std::vector<RecentFile> without(std::vector<RecentFile> files, const fs::path& path) {
  std::erase_if(files, [&](const RecentFile& file) { return file.path == path; });
  return files;
}

}  // namespace

std::vector<RecentFile> readRecent(const fs::path& list) {
  std::vector<RecentFile> files;
  std::istringstream in(readWhole(list));
  for (std::string line; files.size() < kMostRecent && std::getline(in, line);) {
    std::istringstream words(line);
    std::int64_t when = 0;
    if (!(words >> when) || when < 0 || when > std::int64_t(1) << 34 || words.get() != '\t') continue;
    std::string path;
    std::getline(words, path);
    if (fs::path(path).is_absolute()) files.push_back({path, system_clock::time_point(seconds(when))});
  }
  return files;
}

void addRecent(const fs::path& list, const fs::path& file) {
  if (!file.is_absolute() || file.string().find('\n') != std::string::npos) return;
  auto files = without(readRecent(list), file);
  files.insert(files.begin(), {file, system_clock::now()});
  if (files.size() > kMostRecent) files.resize(kMostRecent);
  write(list, files);
}

void removeRecent(const fs::path& list, const fs::path& file) { write(list, without(readRecent(list), file)); }

fs::path recentList() { return stateFolder() / "recent"; }

fs::path recentPicture(const fs::path& file) {
  std::uint64_t hash = 14695981039346656037ull;
  for (unsigned char c : file.string()) hash = (hash ^ c) * 1099511628211ull;
  return cacheFolder() / "recent" / fmt::format("{:016x}.png", hash);
}

std::vector<fs::path> recentFolders(const fs::path& list) {
  std::vector<fs::path> folders;
  for (const auto& file : readRecent(list))
    if (std::find(folders.begin(), folders.end(), file.path.parent_path()) == folders.end())
      folders.push_back(file.path.parent_path());
  return folders;
}

}  // namespace velum::session
