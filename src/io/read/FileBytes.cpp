#include "io/read/FileBytes.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace velum::io {

std::uint64_t sizeOfFile(const Path& file) {
  std::error_code error;
  auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) refuse(file, "there is no such file");
  if (!std::filesystem::is_regular_file(status)) refuse(file, "is not a regular file");
  std::uint64_t size = std::filesystem::file_size(file, error);
  if (error) refuse(file, error.message());
  return size;
}

std::string stampOf(const Path& file) {
  std::uint64_t size = sizeOfFile(file);
  std::error_code error;
  auto changed = std::filesystem::last_write_time(file, error);
  if (error) refuse(file, error.message());
  return fmt::format("{} {}", size, changed.time_since_epoch().count());
}

FileBytes::FileBytes(const Path& path) : mPath(path), mSize(sizeOfFile(path)) {
  // A pipe that took the file's place meanwhile must not hold us up.
  mFile = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (mFile < 0) refuse(path, fmt::format("cannot be opened ({})", std::strerror(errno)));
}

FileBytes::~FileBytes() { ::close(mFile); }

std::size_t FileBytes::readSome(std::uint64_t at, std::span<std::byte> to) const {
  std::size_t done = 0;
  while (done < to.size()) {
    ssize_t got = ::pread(mFile, to.data() + done, to.size() - done, off_t(at + done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) refuse(mPath, fmt::format("cannot be read ({})", std::strerror(errno)));
    if (got == 0) break;
    done += std::size_t(got);
  }
  return done;
}

void FileBytes::read(std::uint64_t at, std::span<std::byte> to) const {
  if (readSome(at, to) != to.size()) refuse(mPath, "the file is cut short");
}

std::string FileBytes::head(std::size_t most) const {
  std::string text(std::size_t(std::min<std::uint64_t>(most, mSize)), '\0');
  read(0, std::as_writable_bytes(std::span(text)));
  return text;
}

}  // namespace velum::io
