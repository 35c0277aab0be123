#include "session/document/JournalFiles.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstring>
#include <functional>
#include <thread>

#include "core/Error.h"

namespace velum::session {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLargestList = 1u << 20, kChunk = 1u << 20;
constexpr const char* kGone = ".gone-";

[[noreturn]] void fail(const fs::path& path, int reason) {
  throw InputError(fmt::format("{}: cannot be written ({})", path.string(), std::strerror(reason)));
}

int openQuietly(const fs::path& path, int flags) { return ::open(path.c_str(), flags | O_CLOEXEC | O_NONBLOCK); }

/// What stands for the lock of a folder. Some file systems lock only what is open for writing, and some files may only
/// be read. @return descriptor; -1: errno says why
int openLock(const fs::path& folder) {
  int lock = openQuietly(folder / "lock", O_RDWR);
  if (lock < 0 && errno != ENOENT && errno != ENOTDIR) lock = openQuietly(folder / "lock", O_RDONLY);
  if (lock < 0 && (errno == ENOENT || errno == ENOTDIR)) lock = openQuietly(folder, O_RDONLY);
  return lock;
}

}  // namespace

fs::path journalPath(const fs::path& folder, int generation) {
  return folder / fmt::format("journal-{}.jsonl", generation);
}

fs::path autosavePath(const fs::path& folder, int generation) {
  return folder / fmt::format("autosave-{}.json", generation);
}

std::vector<int> generationsIn(const fs::path& folder, std::error_code& error) {
  std::vector<int> found;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    std::string name = entry->path().filename().string();
    std::size_t begin = name.starts_with("journal-") ? 8 : name.starts_with("autosave-") ? 9 : 0;
    int generation = 0;
    if (begin == 0 || std::from_chars(name.data() + begin, name.data() + name.size(), generation).ec != std::errc())
      continue;
    if (name == journalPath({}, generation) || name == autosavePath({}, generation)) found.push_back(generation);
  }
  std::sort(found.begin(), found.end(), std::greater<>());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

int makeLockedFolder(const fs::path& hidden) {
  std::error_code error;
  fs::create_directories(hidden, error);
  if (error) fail(hidden, error.value());
  // What a scan is called, and where it lies, concerns nobody else.
  fs::permissions(hidden, fs::perms::owner_all, error);
  int lock = ::open((hidden / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  // Another process may be looking at it just now, for milliseconds.
  for (int tries = 0; lock >= 0 && tries < 20; ++tries) {
    if (::flock(lock, LOCK_EX | LOCK_NB) == 0) return lock;
    if (errno != EWOULDBLOCK) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  int reason = errno;
  if (lock >= 0) ::close(lock);
  fs::remove_all(hidden, error);
  fail(hidden, reason);
}

void publishFolder(const fs::path& hidden, const fs::path& folder) {
  if (::rename(hidden.c_str(), folder.c_str()) != 0) fail(folder, errno);
}

std::error_code removeFolder(const fs::path& folder) {
  std::error_code error, ignored;
  fs::path gone = isBeingRemoved(folder) ? folder : folder.parent_path() / (kGone + folder.filename().string());
  fs::rename(folder, gone, error);
  fs::remove_all(error ? folder : gone, error);
  if (error) fs::rename(gone, folder, ignored);
  return error;
}

bool isBeingRemoved(const fs::path& folder) { return folder.filename().string().starts_with(kGone); }

LockTry tryLock(const fs::path& folder, LockKind kind) {
  int lock = openLock(folder);
  if (lock >= 0 && ::flock(lock, (kind == LockKind::Shared ? LOCK_SH : LOCK_EX) | LOCK_NB) == 0) {
    struct stat state {};
    if (::fstat(lock, &state) == 0 && state.st_nlink > 0) return {lock, {}};
    errno = ENOENT;  // who held it has removed it
  }
  LockTry out;
  if (lock < 0 || errno != EWOULDBLOCK) out.whyNot = std::strerror(errno);
  if (lock >= 0) ::close(lock);
  return out;
}

FileText readFile(const fs::path& path, std::size_t most) {
  FileText out;
  int file = openQuietly(path, O_RDONLY);
  struct stat state {};
  if (file < 0 && errno == ENOENT) return out;
  if (file < 0 || ::fstat(file, &state) != 0)
    out.whyNot = std::strerror(errno);
  else if (!S_ISREG(state.st_mode))
    out.whyNot = "it is no file";
  while (out.whyNot.empty()) {
    std::size_t before = out.text.size(), room = std::min(kChunk, most + 1 - before);
    out.text.resize(before + room);
    ssize_t got = ::read(file, out.text.data() + before, room);
    int reason = errno;
    out.text.resize(before + std::size_t(std::max<ssize_t>(0, got)));
    if (got < 0 && reason == EINTR) continue;
    if (got < 0) out.whyNot = std::strerror(reason);
    if (out.text.size() > most) {
      out.whyNot = fmt::format("it is larger than {} MiB", most >> 20);
      out.text.resize(most);
    }
    if (got == 0) break;
  }
  if (file >= 0) ::close(file);
  return out;
}

std::string readWhole(const fs::path& path) {
  FileText read = readFile(path, kLargestList);
  return read.whyNot.empty() ? std::move(read.text) : std::string();
}

}  // namespace velum::session
