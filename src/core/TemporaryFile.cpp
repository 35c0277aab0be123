#include "core/TemporaryFile.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <mutex>
#include <set>
#include <string_view>

namespace velum {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kPrefix = ".velum-";
constexpr std::size_t kDigits = 16;
/// File systems limit a name to 255 bytes; so much of the target's, from its end, leaves room for what is put before
/// it.
constexpr std::size_t kKeptName = 200;

/// 64 bits of the system's randomness as hexadecimal digits; empty when it has none.
std::string randomDigits() {
  std::uint64_t number = 0;
  if (::getrandom(&number, sizeof number, 0) != ssize_t(sizeof number)) return {};
  char digits[kDigits];
  char* end = std::to_chars(digits, digits + kDigits, number, 16).ptr;
  return std::string(kDigits - std::size_t(end - digits), '0') + std::string(digits, end);
}

bool isTemporaryName(std::string_view name) {
  if (!name.starts_with(kPrefix) || name.size() <= kPrefix.size() + kDigits) return false;
  std::string_view digits = name.substr(kPrefix.size(), kDigits);
  return digits.find_first_not_of("0123456789abcdef") == digits.npos && name[kPrefix.size() + kDigits] == '-';
}

void removeIfLeft(const fs::path& path) {
  int file = ::open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return;
  struct stat status {};
  bool isOurs = ::fstat(file, &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == ::geteuid();
  if (isOurs && ::flock(file, LOCK_EX | LOCK_NB) == 0) ::unlink(path.c_str());
  ::close(file);
}

/// Once for each folder: pictures of an animation go to one with thousands of files.
void removeLeftovers(const fs::path& folder) {
  static std::mutex mutex;
  static std::set<fs::path> done;
  {
    std::lock_guard guard(mutex);
    std::error_code error;
    if (!done.insert(fs::absolute(folder, error)).second) return;
  }
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (isTemporaryName(entry->path().filename().native())) removeIfLeft(entry->path());
}

/// @return false when another process took it for a leftover before it was locked
bool lock(int file) {
  // Where a file system has no locks, nobody can get one to remove it.
  while (::flock(file, LOCK_EX) != 0 && errno == EINTR) {
  }
  struct stat status {};
  return ::fstat(file, &status) == 0 && status.st_nlink > 0;
}

}  // namespace

TemporaryFile makeTemporaryFile(const fs::path& folder, const std::string& name, unsigned mode) {
  removeLeftovers(folder);
  constexpr int kTries = 100;
  std::string kept = name.substr(name.size() - std::min(name.size(), kKeptName));
  for (int i = 0; i < kTries; ++i) {
    std::string digits = randomDigits();
    if (digits.empty()) return {};
    TemporaryFile made{-1, std::string(kPrefix) + digits + "-" + kept};
    made.descriptor = ::open((folder / made.name).c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
    if (made.descriptor < 0 && errno != EEXIST) return {};
    if (made.descriptor < 0) continue;
    if (lock(made.descriptor)) return made;
    ::close(made.descriptor);
  }
  errno = EEXIST;
  return {};
}

}  // namespace velum
