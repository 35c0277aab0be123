#include "velum/core/ReplaceFile.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include "velum/core/Assert.h"
#include "velum/core/Error.h"

namespace velum {

namespace fs = std::filesystem;

namespace {

/// File systems limit a name to 255 bytes; so much of the target's, from its end, leaves room for what is put before
/// it.
constexpr std::size_t kKeptName = 200;

[[noreturn]] void fail(const fs::path& target, int reason) {
  throw InputError(target.string() + ": cannot be written (" + std::strerror(reason) +
                   "); check the folder and the free space");
}

/// A file or a folder. Some file systems cannot sync (EINVAL, ENOTSUP); that is no reason to refuse what was written.
/// @return 0, or why not
int sync(const fs::path& path) {
  int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return errno;
  int result = ::fsync(file) == 0 || errno == EINVAL || errno == ENOTSUP ? 0 : errno;
  ::close(file);
  return result;
}

fs::path folderOf(const fs::path& target) { return target.parent_path().empty() ? "." : target.parent_path(); }

/// The end of the name is kept, for libraries choose the format by it.
fs::path temporaryFor(const fs::path& target) {
  static std::atomic<unsigned> turn{0};
  std::string name = target.filename().string();
  name = name.substr(name.size() - std::min(name.size(), kKeptName));
  return target.parent_path() / (".velum-" + std::to_string(::getpid()) + "-" + std::to_string(turn++) + "-" + name);
}

}  // namespace

ReplaceFile::ReplaceFile(fs::path target, Access access) : mTarget(std::move(target)) {
  if (!fs::is_directory(folderOf(mTarget)))
    throw InputError(mTarget.string() + ": its folder does not exist; create it first");
  if (fs::is_directory(mTarget)) throw InputError(mTarget.string() + ": is a folder; give the name of a file");
  mTemporary = temporaryFor(mTarget);
  // One that is left over from a process of the same number is nobody's.
  ::unlink(mTemporary.c_str());
  mFile = ::open(mTemporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC,
                 access == Access::Owner ? 0600 : 0666);
  if (mFile < 0) fail(mTarget, errno);
}

ReplaceFile::~ReplaceFile() {
  if (mFile >= 0) ::close(mFile);
  if (!mIsCommitted) ::unlink(mTemporary.c_str());
}

void ReplaceFile::write(std::span<const std::byte> bytes) {
  VELUM_ASSERT(mFile >= 0, "the file is still being written");
  if (!writeAll(mFile, bytes)) fail(mTarget, errno);
}

void ReplaceFile::write(std::string_view text) { write(std::as_bytes(std::span(text))); }

void ReplaceFile::commit(Sync when) {
  VELUM_ASSERT(!mIsCommitted, "a file is committed once");
  // A library may have written it under its name, so it is the name that is synced.
  if (when == Sync::Now) {
    closeFile();
    if (int reason = sync(mTemporary)) fail(mTarget, reason);
  }
  if (::rename(mTemporary.c_str(), mTarget.c_str()) != 0) fail(mTarget, errno);
  mIsCommitted = true;
  // The new name is on the disk when its folder is.
  if (when == Sync::Now)
    if (int reason = sync(folderOf(mTarget))) fail(mTarget, reason);
}

int ReplaceFile::releaseDescriptor() {
  VELUM_ASSERT(mFile >= 0, "the file is still open");
  return std::exchange(mFile, -1);
}

/// Network file systems say only here that there was no room.
void ReplaceFile::closeFile() {
  if (mFile >= 0 && ::close(std::exchange(mFile, -1)) != 0 && errno != EINTR) fail(mTarget, errno);
}

bool writeAll(int descriptor, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written == 0) errno = ENOSPC;
    if (written <= 0) return false;
    bytes = bytes.subspan(std::size_t(written));
  }
  return true;
}

void replaceFile(const fs::path& target, std::string_view text, ReplaceFile::Access access) {
  ReplaceFile file(target, access);
  file.write(text);
  file.commit();
}

}  // namespace velum
