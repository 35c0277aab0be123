#include "core/ReplaceFile.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include "core/Assert.h"
#include "core/Error.h"
#include "core/TemporaryFile.h"

namespace velum {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& target, int reason) {
  throw InputError(target.string() + ": cannot be written (" + std::strerror(reason) +
                   "); check the folder and the free space");
}

/// Some file systems cannot sync (EINVAL, ENOTSUP); that is no reason to refuse what was written. @return 0, or why not
int sync(int file) { return ::fsync(file) == 0 || errno == EINVAL || errno == ENOTSUP ? 0 : errno; }

int syncFolder(const fs::path& folder) {
  int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) return errno;
  int result = sync(file);
  ::close(file);
  return result;
}

fs::path folderOf(const fs::path& target) { return target.parent_path().empty() ? "." : target.parent_path(); }

fs::path behindLinks(const fs::path& named) {
  constexpr int kMostLinks = 40;  // as many as Linux follows
  fs::path place = named;
  for (int i = 0; i < kMostLinks; ++i) {
    std::error_code error;
    if (!fs::is_symlink(fs::symlink_status(place, error))) return place;
    fs::path next = fs::read_symlink(place, error);
    place = next.is_absolute() ? next : place.parent_path() / next;
  }
  fail(named, ELOOP);
}

/// @throw InputError when what is there may not be replaced
void checkOld(const fs::path& target, const fs::path& place) {
  std::error_code error;
  fs::file_status old = fs::status(place, error);
  if (fs::is_directory(old)) throw InputError(target.string() + ": is a folder; give the name of a file");
  if (!fs::exists(old)) return;
  if (!fs::is_regular_file(old)) throw InputError(target.string() + ": is no regular file; give the name of a file");
  // An administrator may write to any file, but a read-only one was meant to stay.
  constexpr fs::perms kWrite = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
  if ((old.permissions() & kWrite) == fs::perms::none || ::access(place.c_str(), W_OK) != 0)
    throw InputError(target.string() + ": is read-only; choose another name, or permit writing");
}

/// Owner, group and mode of the file that will be replaced; as much as the system permits.
void takeAfter(int file, const struct stat& old) {
  if (::fchown(file, old.st_uid, old.st_gid) != 0 && ::fchown(file, uid_t(-1), old.st_gid) != 0) errno = 0;
  if (::fchmod(file, old.st_mode & 07777) != 0) errno = 0;
}

/// Network file systems say only at a close that there was no room, so a second descriptor is closed.
int tryClose(int file) {
  int second = ::fcntl(file, F_DUPFD_CLOEXEC, 0);
  if (second < 0) return errno;
  return ::close(second) == 0 || errno == EINTR ? 0 : errno;
}

}  // namespace

ReplaceFile::ReplaceFile(fs::path target, Access access) : mTarget(std::move(target)), mPlace(behindLinks(mTarget)) {
  if (!fs::is_directory(folderOf(mPlace)))
    throw InputError(mTarget.string() + ": its folder does not exist; create it first");
  checkOld(mTarget, mPlace);
  makeTemporary(access);
}

void ReplaceFile::makeTemporary(Access access) {
  struct stat old {};
  bool replaces = ::stat(mPlace.c_str(), &old) == 0;
  bool isPrivate = replaces || access == Access::Owner;
  TemporaryFile made = makeTemporaryFile(folderOf(mPlace), mPlace.filename(), isPrivate ? 0600 : 0666);
  if (made.descriptor < 0) fail(mTarget, errno);
  mFile = made.descriptor;
  mTemporary = mPlace.parent_path() / made.name;
  if (replaces && access == Access::Everybody) takeAfter(mFile, old);
}

ReplaceFile::~ReplaceFile() {
  if (!mIsCommitted) ::unlink(mTemporary.c_str());
  if (mFile >= 0) ::close(mFile);
}

void ReplaceFile::write(std::span<const std::byte> bytes) {
  VELUM_ASSERT(mFile >= 0, "the file is still being written");
  if (mRefusal == 0 && !writeAll(mFile, bytes)) mRefusal = errno;
  throwIfRefused();
}

void ReplaceFile::write(std::string_view text) { write(std::as_bytes(std::span(text))); }

bool ReplaceFile::writeAt(std::uint64_t offset, std::span<const std::byte> bytes) {
  VELUM_ASSERT(mFile >= 0, "the file is still being written");
  if (mRefusal == 0 && (::lseek(mFile, off_t(offset), SEEK_SET) < 0 || !writeAll(mFile, bytes))) mRefusal = errno;
  return mRefusal == 0;
}

void ReplaceFile::throwIfRefused() const {
  if (mRefusal != 0) fail(mTarget, mRefusal);
}

void ReplaceFile::commit(Sync when) {
  VELUM_ASSERT(!mIsCommitted, "a file is committed once");
  if (mRefusal == 0) mRefusal = tryClose(mFile);
  if (mRefusal == 0 && when == Sync::Now) mRefusal = sync(mFile);
  if (mRefusal == 0 && ::rename(mTemporary.c_str(), mPlace.c_str()) != 0) mRefusal = errno;
  throwIfRefused();
  mIsCommitted = true;
  if (when == Sync::ByCaller) return;
  ::close(std::exchange(mFile, -1));
  // The new name is on the disk when its folder is.
  if (int reason = syncFolder(folderOf(mPlace))) fail(mTarget, reason);
}

int ReplaceFile::releaseDescriptor() {
  VELUM_ASSERT(mFile >= 0, "the file is still open");
  ::fcntl(mFile, F_SETFL, O_APPEND);
  return std::exchange(mFile, -1);
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

void expectReplaceable(const fs::path& target) { ReplaceFile trial(target); }

void replaceFile(const fs::path& target, std::string_view text, ReplaceFile::Access access) {
  ReplaceFile file(target, access);
  file.write(text);
  file.commit();
}

}  // namespace velum
