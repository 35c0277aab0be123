#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

namespace velum {

/// The one way in which we write files: a crash, a kill or a full disk leaves the old file or the new one and never
/// half of one.
///
/// All goes to a temporary in the same folder. `commit()` brings it to the disk and gives it the target's name; it
/// refuses when any write before was refused, so that a library that does not look cannot hide that. Without a commit
/// the temporary is removed; what a killed process left of its own is removed by the next that writes to that folder.
/// Through a symbolic link its target is written. The old file's mode and, where the system permits, its owner are
/// kept. One thread at a time.
class ReplaceFile {
 public:
  enum class Access { Everybody, Owner };  ///< Who may read a new file: as the umask says, or nobody else.
  enum class Sync { Now, ByCaller };       ///< On the disk when commit() returns, or when the caller sees to it.

  /// Makes an empty temporary.
  /// @throw InputError when there is no such folder, it may not be written to, or the target is read-only, a folder or
  ///        anything else that is no regular file
  explicit ReplaceFile(std::filesystem::path target, Access access = Access::Everybody);
  ~ReplaceFile();
  ReplaceFile(const ReplaceFile&) = delete;
  ReplaceFile& operator=(const ReplaceFile&) = delete;

  /// The file that is replaced, as it was named: what messages name, and what tells the format.
  const std::filesystem::path& target() const { return mTarget; }

  /// Appends all of it. @throw InputError when the disk refuses
  void write(std::span<const std::byte> bytes);
  void write(std::string_view text);
  /// For libraries that go back to what they wrote before, and take errors in their own way.
  /// @param offset  in bytes from the begin  @return false when the disk refuses; commit() will throw
  bool writeAt(std::uint64_t offset, std::span<const std::byte> bytes);

  /// What commit() will say. @throw InputError when the disk has refused a write
  void throwIfRefused() const;

  /// Puts the new file in the place of the old one. Once. @throw InputError when the disk refuses, or refused before
  void commit(Sync sync = Sync::Now);
  /// The file, open for appending, for the caller to write on and to close. Once; after a commit by ByCaller.
  int releaseDescriptor();

 private:
  void makeTemporary(Access access);

  std::filesystem::path mTarget;     ///< As named.
  std::filesystem::path mPlace;      ///< The same behind symbolic links.
  std::filesystem::path mTemporary;  ///< In the folder of mPlace.
  int mFile = -1;
  int mRefusal = 0;  ///< errno of the first write that failed.
  bool mIsCommitted = false;
};

/// Writes all bytes at the file's place, however often the system takes only some of them or is interrupted.
/// @param descriptor  open for writing
/// @return false when the system refuses; errno says why
bool writeAll(int descriptor, std::span<const std::byte> bytes);

/// Asks before the work that fills a file whether it could be replaced; leaves nothing. @throw InputError as
/// ReplaceFile
void expectReplaceable(const std::filesystem::path& target);

/// Replaces a file by this text, on the disk at return. @throw InputError when the disk refuses
void replaceFile(const std::filesystem::path& target, std::string_view text,
                 ReplaceFile::Access access = ReplaceFile::Access::Everybody);

}  // namespace velum
