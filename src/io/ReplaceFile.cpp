#include "ReplaceFile.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>

#include "velum/core/Error.h"

namespace velum::io {

namespace {
void sync(const std::filesystem::path& path) {
  int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  int result = file < 0 ? -1 : ::fsync(file);
  int reason = errno;
  if (file >= 0) ::close(file);
  // Some file systems cannot sync (EINVAL); that is no reason to refuse the picture.
  if (result < 0 && reason != EINVAL && reason != ENOTSUP)
    throw InputError(fmt::format("{}: cannot be written ({})", path.string(), std::strerror(reason)));
}
}  // namespace

ReplaceFile::ReplaceFile(std::filesystem::path target) : mTarget(std::move(target)) {
  static std::atomic<unsigned> turn{0};
  auto folder = mTarget.parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder))
    throw InputError(fmt::format("{}: the folder does not exist; create it first", folder.string()));
  if (std::filesystem::is_directory(mTarget))
    throw InputError(fmt::format("{}: is a folder; give the name of a file", mTarget.string()));
  auto name = fmt::format(".{}.{}-{}{}", mTarget.stem().string(), ::getpid(), turn++, mTarget.extension().string());
  mTemporary = folder / name;
}

ReplaceFile::~ReplaceFile() {
  std::error_code ignored;
  if (!mCommitted) std::filesystem::remove(mTemporary, ignored);
}

void ReplaceFile::commit() {
  sync(mTemporary);
  std::error_code error;
  std::filesystem::rename(mTemporary, mTarget, error);
  if (error) throw InputError(fmt::format("{}: cannot be written ({})", mTarget.string(), error.message()));
  mCommitted = true;
}

}  // namespace velum::io
