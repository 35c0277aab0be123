#pragma once
#include <filesystem>
#include <string_view>

namespace velum::io {

/// Writes a file so that a crash, or a full disk, leaves the old one or the new one and never half of one: the caller
/// writes to `temporary()`, then calls `commit()`, which syncs it to the disk and renames it. Without a commit the
/// temporary is removed.
class ReplaceFile {
 public:
  /// @throw InputError when the folder does not exist
  explicit ReplaceFile(std::filesystem::path target);
  ~ReplaceFile();
  ReplaceFile(const ReplaceFile&) = delete;
  ReplaceFile& operator=(const ReplaceFile&) = delete;

  /// Beside the target, with the target's extension (some libraries choose the format by it).
  const std::filesystem::path& temporary() const { return mTemporary; }
  /// @throw InputError when the disk refuses
  void commit();

 private:
  std::filesystem::path mTarget, mTemporary;
  bool mCommitted = false;
};

}  // namespace velum::io
