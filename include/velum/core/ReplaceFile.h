#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

namespace velum {

/// The one way in which we write files: a crash, or a full disk, leaves the old file or the new one and never half of
/// one.
///
/// All goes to a temporary in the same folder, through `write()` or by its name for libraries that open files
/// themselves. `commit()` brings it to the disk and gives it the target's name. Without a commit the temporary is
/// removed. One thread at a time.
class ReplaceFile {
 public:
  enum class Access { Everybody, Owner };  ///< Who may read the new file: as the umask says, or nobody else.
  enum class Sync { Now, ByCaller };       ///< On the disk when commit() returns, or when the caller sees to it.

  /// Makes an empty temporary.
  /// @throw InputError when there is no such folder, it may not be written to, or the target is a folder
  explicit ReplaceFile(std::filesystem::path target, Access access = Access::Everybody);
  ~ReplaceFile();
  ReplaceFile(const ReplaceFile&) = delete;
  ReplaceFile& operator=(const ReplaceFile&) = delete;

  /// The file that is replaced: what messages name.
  const std::filesystem::path& target() const { return mTarget; }
  /// For libraries that open files by name: in the target's folder, and its name ends as the target's does.
  const std::filesystem::path& temporary() const { return mTemporary; }

  /// Appends all of it. @throw InputError when the disk refuses
  void write(std::span<const std::byte> bytes);
  void write(std::string_view text);

  /// Puts the new file in the place of the old one. Once. @throw InputError when the disk refuses
  void commit(Sync sync = Sync::Now);
  /// The open file, at its end, for the caller to write on and to close. Once.
  int releaseDescriptor();

 private:
  void closeFile();

  std::filesystem::path mTarget, mTemporary;
  int mFile = -1;
  bool mIsCommitted = false;
};

/// Writes all bytes at the file's place, however often the system takes only some of them or is interrupted.
/// @param descriptor  open for writing
/// @return false when the system refuses; errno says why
bool writeAll(int descriptor, std::span<const std::byte> bytes);

/// Replaces a file by this text, on the disk at return. @throw InputError when the disk refuses
void replaceFile(const std::filesystem::path& target, std::string_view text,
                 ReplaceFile::Access access = ReplaceFile::Access::Everybody);

}  // namespace velum
