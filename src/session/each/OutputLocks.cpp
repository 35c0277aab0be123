#include "session/each/OutputLocks.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <set>
#include <system_error>

#include "core/Error.h"

namespace velum::session {

namespace fs = std::filesystem;

namespace {

/// File systems limit a name to 255 bytes.
constexpr std::size_t kKeptOfName = 200;

/// The file that is written under a name, behind links: as ReplaceFile finds it.
fs::path realOutput(const fs::path& output) {
  std::error_code error;
  fs::path whole = fs::absolute(output);
  fs::path folder = fs::weakly_canonical(whole.parent_path(), error);
  fs::path file = error ? whole : folder / whole.filename();
  if (!fs::is_symlink(file, error)) return file;
  fs::path behind = fs::weakly_canonical(file, error);
  return error ? file : behind;
}

fs::path lockOf(const fs::path& file) { return file.parent_path() / (".velum-lock-" + nameOfWholePath(file)); }

/// Whether the file that is open still has its name. Opening it once more asks the server of a network's files, too.
bool hasItsName(int descriptor, const fs::path& lock) {
  int again = ::open(lock.c_str(), O_RDONLY | O_CLOEXEC);
  if (again < 0) return false;
  struct stat held {
  }, named{};
  bool isSame = ::fstat(descriptor, &held) == 0 && ::fstat(again, &named) == 0 && held.st_ino == named.st_ino &&
                held.st_dev == named.st_dev;
  ::close(again);
  return isSame;
}

/// @return -1 while another process has it, or where the disk refuses: errno is EWOULDBLOCK, or says why
int takeLock(const fs::path& lock) {
  for (;;) {
    int descriptor = ::open(lock.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor < 0) return -1;
    bool isLocked = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
    int why = errno;
    if (isLocked && hasItsName(descriptor, lock)) return descriptor;
    // Else whoever had it has removed it between two of these lines.
    ::close(descriptor);
    errno = why;
    if (!isLocked && why != EINTR && why != ESTALE) return -1;
  }
}

}  // namespace

std::string nameOfWholePath(const fs::path& path) {
  std::uint64_t sum = 0xcbf29ce484222325u;  // FNV-1a
  for (char c : path.string()) sum = (sum ^ std::uint8_t(c)) * 0x100000001b3u;
  std::string name = path.filename().string();
  return fmt::format("{:016x}-{}", sum, name.substr(name.size() - std::min(name.size(), kKeptOfName)));
}

std::optional<OutputLocks> OutputLocks::take(const std::vector<fs::path>& outputs) {
  std::set<fs::path> files;
  for (const fs::path& output : outputs) {
    std::error_code error;
    if (output.has_parent_path()) fs::create_directories(output.parent_path(), error);
    files.insert(realOutput(output));
  }
  OutputLocks locks;
  for (const fs::path& file : files) {
    int descriptor = takeLock(lockOf(file));
    if (descriptor < 0 && errno == EWOULDBLOCK) return std::nullopt;
    if (descriptor < 0)
      throw InputError(fmt::format("{}: cannot be locked ({})", file.string(), std::generic_category().message(errno)));
    locks.mHeld.push_back({lockOf(file), descriptor});
  }
  return locks;
}

OutputLocks::~OutputLocks() {
  for (const Held& held : mHeld) {
    ::unlink(held.file.c_str());
    ::close(held.descriptor);
  }
}

}  // namespace velum::session
