#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "io/read/Refuse.h"

namespace velum::io {

/// Size of a regular file. @throw InputError when it is missing or not a regular file
std::uint64_t sizeOfFile(const Path& file);

/// The size of a regular file and when it was last changed, to the nanosecond. @throw InputError as sizeOfFile() does
std::string stampOf(const Path& file);

/// A file from which bytes are read at any offset. The file is never mapped into memory, so that a file that shrinks
/// meanwhile leads to an error and not to a crash.
class FileBytes {
 public:
  /// @throw InputError when the file is missing, not a regular file or cannot be opened
  explicit FileBytes(const Path& path);
  ~FileBytes();
  FileBytes(const FileBytes&) = delete;
  FileBytes& operator=(const FileBytes&) = delete;

  const Path& path() const { return mPath; }
  std::uint64_t size() const { return mSize; }
  /// Fills all of `to` from byte `at`. @throw InputError when the file ends before
  void read(std::uint64_t at, std::span<std::byte> to) const;
  /// @return how many bytes were read: fewer than asked for only at the file's end. @throw InputError when the disk
  /// refuses
  std::size_t readSome(std::uint64_t at, std::span<std::byte> to) const;
  /// The file's first bytes, at most `most`.
  std::string head(std::size_t most) const;

 private:
  Path mPath;
  int mFile = -1;
  std::uint64_t mSize = 0;
};

}  // namespace velum::io
