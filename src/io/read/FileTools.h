#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "velum/core/Volume.h"
#include "velum/scene/Source.h"

/// What the readers share: refusing with words, bounded reading, byte order, spacing. Any thread.
namespace velum::io {

/// @throw InputError "path: reason", always
[[noreturn]] void refuse(const std::filesystem::path& path, std::string_view reason);

/// A file read at places, never mapped, so that a file that shrinks meanwhile is an error and not a crash.
class FileBytes {
 public:
  /// @throw InputError when it is missing, a folder or cannot be opened
  explicit FileBytes(const std::filesystem::path& path);
  ~FileBytes();
  FileBytes(const FileBytes&) = delete;
  FileBytes& operator=(const FileBytes&) = delete;

  std::uint64_t size() const { return mSize; }
  /// Fills all of `to` from byte `at`. @throw InputError when the file ends before
  void read(std::uint64_t at, std::span<std::byte> to) const;
  /// At most `most` bytes from the start.
  std::string head(std::size_t most) const;

 private:
  std::filesystem::path mPath;
  int mFile = -1;
  std::uint64_t mSize = 0;
};

/// A gzip file (or a plain one) read in order. @throw InputError from all of it
class GzipFile {
 public:
  explicit GzipFile(const std::filesystem::path& path);
  ~GzipFile();
  GzipFile(const GzipFile&) = delete;
  GzipFile& operator=(const GzipFile&) = delete;

  /// Reads up to to.size() bytes; fewer at the end only. A damaged or cut stream throws.
  std::size_t readSome(std::span<std::byte> to);
  /// Fills all of `to`.
  void read(std::span<std::byte> to);
  /// Passes over `count` bytes; the number passed is smaller at the end only.
  std::uint64_t skip(std::uint64_t count);
  /// More bytes than this cannot come out: deflate makes at most 1032 of one.
  std::uint64_t mostBytes() const;

 private:
  std::filesystem::path mPath;
  void* mFile = nullptr;
};

/// Bytes of dims x channels x frames samples, checked for overflow and against `mostBytes`.
/// @throw InputError naming both byte counts when the file cannot hold so much, or a dimension is < 1
std::size_t checkedBytes(const std::filesystem::path& path, glm::dvec3 dims, double channels, double frames,
                         SampleType type, double mostBytes);

/// Reverses the bytes of each sample of `sampleBytes` (1, 2, 4 or 8).
void swapBytes(std::span<std::byte> bytes, std::size_t sampleBytes);

/// A grid along the world's axes, voxel 0 at the origin.
glm::dmat4 gridMatrix(glm::dvec3 spacingMm, glm::dvec3 originMm = glm::dvec3(0.0));

/// Takes the user's spacing where positive, then warns when spacing is still unknown. Harmless when done twice.
void applySpacing(Volume& volume, const scene::Source& source);

/// "slice2" before "slice10": runs of digits compare as numbers.
bool naturalLess(std::string_view a, std::string_view b);

/// Regular files of a folder that are not hidden, in natural order of their names.
std::vector<std::filesystem::path> filesInOrder(const std::filesystem::path& folder);

/// Name for people: the file's, without extension.
std::string titleOf(const std::filesystem::path& path);

}  // namespace velum::io
