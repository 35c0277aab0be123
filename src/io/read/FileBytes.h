#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "io/read/Refuse.h"

namespace velum::io {

/// Size of a regular file. @throw InputError when it is missing or not a regular file
std::uint64_t sizeOfFile(const Path& file);

/// A file read at places, never mapped, so that a file that shrinks meanwhile is an error and not a crash.
class FileBytes {
 public:
  /// @throw InputError when it is missing, not a regular file or cannot be opened
  explicit FileBytes(const Path& path);
  ~FileBytes();
  FileBytes(const FileBytes&) = delete;
  FileBytes& operator=(const FileBytes&) = delete;

  const Path& path() const { return mPath; }
  std::uint64_t size() const { return mSize; }
  /// Fills all of `to` from byte `at`. @throw InputError when the file ends before
  void read(std::uint64_t at, std::span<std::byte> to) const;
  /// Fewer bytes than asked for at the end only. @throw InputError when the disk refuses
  std::size_t readSome(std::uint64_t at, std::span<std::byte> to) const;
  /// At most `most` bytes from the start.
  std::string head(std::size_t most) const;

 private:
  Path mPath;
  int mFile = -1;
  std::uint64_t mSize = 0;
};

}  // namespace velum::io
