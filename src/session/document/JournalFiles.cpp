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
  throw InputError(
      fmt::format("{}: cannot be written ({}); unsaved work is not protected", path.string(), std::strerror(errno)));
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

void writeAll(int file, std::string_view text, const fs::path& path) {
  while (!text.empty()) {
    ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail(path);
    text.remove_prefix(std::size_t(written));
  }
}

void writeSynced(const fs::path& path, std::string_view text) {
  fs::path temporary = path;
  temporary += ".tmp";
  int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (file < 0) fail(path);
  try {
    writeAll(file, text, path);
    if (::fsync(file) != 0 && errno != EINVAL && errno != ENOTSUP) fail(path);
  } catch (...) {
    ::close(file);
    ::unlink(temporary.c_str());
    throw;
  }
  ::close(file);
  if (::rename(temporary.c_str(), path.c_str()) != 0) fail(path);
}

std::string readWhole(const fs::path& path) {
  std::error_code error;
  auto size = fs::file_size(path, error);
  if (error || size > kLargest) return {};
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace velum::session
