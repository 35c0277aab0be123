#pragma once
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace velum::io {

/// A file in memory under a name in the working folder, for some readers and libraries choose by its ending.
class FuzzFile {
 public:
  explicit FuzzFile(const std::string& name)
      : mPath(std::filesystem::absolute(name)), mFile(::memfd_create(name.c_str(), 0)) {
    show();
  }

  const std::filesystem::path& path() const { return mPath; }
  /// Is there, and holds these bytes.
  void hold(const std::uint8_t* data, std::size_t size) {
    bool isWritten = ::ftruncate(mFile, 0) == 0 && ::pwrite(mFile, data, size, 0) == ssize_t(size);
    if (!isWritten) ::_exit(1);  // no memory: no finding
    if (!mIsShown) show();
  }
  /// Is not there.
  void hide() {
    if (mIsShown) std::filesystem::remove(mPath);
    mIsShown = false;
  }

 private:
  void show() {
    std::filesystem::remove(mPath);
    std::filesystem::create_symlink("/proc/self/fd/" + std::to_string(mFile), mPath);
    mIsShown = true;
  }
  std::filesystem::path mPath;
  int mFile;
  bool mIsShown = false;
};

}  // namespace velum::io
