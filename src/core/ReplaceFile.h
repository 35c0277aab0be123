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
/// All bytes go to a temporary file in the same folder. `commit()` brings that file to the disk and gives it the
/// target's name. commit() throws when any write before it was refused, so that a library that does not check its
/// writes cannot hide a refusal. Without a commit the temporary is removed; a temporary that a killed process left
/// behind is removed by the next process that writes to that folder. Where the target is a symbolic link, the file that
/// the link points to is replaced. The old file's mode and, where the system permits, its owner are kept. One thread at
/// a time.
class ReplaceFile {
 public:
  enum class Access { Everybody, Owner };  ///< Who may read a new file: whoever the umask lets, or its owner only.
  enum class Sync {
    Now,
    ByCaller
  };  ///< Whether commit() waits until the file is on the disk, or the caller does that.

  /// Makes an empty temporary file.
  /// @throw InputError when there is no such folder, it may not be written to, or the target is read-only, a folder or
  ///        anything else that is no regular file
  explicit ReplaceFile(std::filesystem::path target, Access access = Access::Everybody);
  ~ReplaceFile();
  ReplaceFile(const ReplaceFile&) = delete;
  ReplaceFile& operator=(const ReplaceFile&) = delete;

  /// The file that is replaced, as the caller named it: for messages, and to choose the format by.
  const std::filesystem::path& target() const { return mTarget; }

  /// Appends all of it. @throw InputError when the disk refuses
  void write(std::span<const std::byte> bytes);
  void write(std::string_view text);
  /// For libraries that go back to what they wrote before, and take errors in their own way.
  /// @param offset  in bytes from the begin  @return false when the disk refuses; commit() will throw
  bool writeAt(std::uint64_t offset, std::span<const std::byte> bytes);

  /// Where the new file grows, for programs that write to a path themselves: what is there may be written over, but not
  /// replaced by another file.
  const std::filesystem::path& temporary() const { return mTemporary; }

  /// Checks early whether commit() would refuse. @throw InputError when the disk has refused a write
  void throwIfRefused() const;

  /// Puts the new file in the place of the old one. Once. @throw InputError when the disk refuses, or refused before
  void commit(Sync sync = Sync::Now);
  /// The descriptor of the new file, open for appending; the caller owns it and closes it. Once; after a commit with
  /// Sync::ByCaller.
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

/// Writes all bytes at the file's current position; goes on when the system takes only some of them or is interrupted.
/// @param descriptor  open for writing
/// @return false when the system refuses; errno says why
bool writeAll(int descriptor, std::span<const std::byte> bytes);

/// Checks, before the work that fills a file, that the file can be replaced. Leaves no file behind. @throw InputError
/// as ReplaceFile
void expectReplaceable(const std::filesystem::path& target);

/// Replaces a file by this text, on the disk at return. @throw InputError when the disk refuses
void replaceFile(const std::filesystem::path& target, std::string_view text,
                 ReplaceFile::Access access = ReplaceFile::Access::Everybody);

}  // namespace velum
