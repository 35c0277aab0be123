#include "JournalFiles.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <functional>

#include "velum/core/Error.h"

namespace velum::session {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kLargest = 64u << 20;

[[noreturn]] void fail(const fs::path& path) {
  throw InputError(fmt::format("{}: cannot be written ({})", path.string(), std::strerror(errno)));
}

}  // namespace

fs::path journalPath(const fs::path& folder, int generation) {
  return folder / fmt::format("journal-{}.jsonl", generation);
}

fs::path autosavePath(const fs::path& folder, int generation) {
  return folder / fmt::format("autosave-{}.json", generation);
}

std::vector<int> generationsIn(const fs::path& folder) {
  std::vector<int> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    std::string name = entry.path().filename().string();
    std::size_t begin = name.starts_with("journal-") ? 8 : name.starts_with("autosave-") ? 9 : 0;
    int generation = 0;
    if (begin == 0 || std::from_chars(name.data() + begin, name.data() + name.size(), generation).ec != std::errc())
      continue;
    if (fs::path name1 = entry.path().filename();
        name1 == journalPath({}, generation) || name1 == autosavePath({}, generation))
      found.push_back(generation);
  }
  std::sort(found.begin(), found.end(), std::greater<>());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

int makeLockedFolder(const fs::path& hidden) {
  std::error_code error;
  fs::create_directories(hidden, error);
  if (error) errno = error.value(), fail(hidden);
  // What a scan is called, and where it lies, concerns nobody else.
  fs::permissions(hidden, fs::perms::owner_all, error);
  int lock = ::open((hidden / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (lock < 0) fail(hidden);
  if (::flock(lock, LOCK_EX | LOCK_NB) != 0) {
    ::close(lock);
    fail(hidden);
  }
  return lock;
}

void publishFolder(const fs::path& hidden, const fs::path& folder) {
  if (::rename(hidden.c_str(), folder.c_str()) != 0) fail(folder);
}

int tryLock(const fs::path& folder, LockKind kind) {
  int lock = ::open((folder / "lock").c_str(), O_RDWR | O_CLOEXEC);
  if (lock < 0) return -1;
  if (::flock(lock, (kind == LockKind::Shared ? LOCK_SH : LOCK_EX) | LOCK_NB) == 0) return lock;
  ::close(lock);
  return -1;
}

std::string readWhole(const fs::path& path) {
  std::error_code error;
  auto size = fs::file_size(path, error);
  if (error || size > kLargest) return {};
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace velum::session
