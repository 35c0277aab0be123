#pragma once
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <string>

namespace velum {

/// A folder of its own for one test, removed at the end.
class TempFolder {
 public:
  TempFolder() {
    static std::atomic<int> turn{0};
    mPath = std::filesystem::temp_directory_path() /
            ("velum-test-" + std::to_string(::getpid()) + "-" + std::to_string(turn++));
    std::filesystem::create_directories(mPath);
  }
  ~TempFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(mPath, ignored);
  }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  const std::filesystem::path& path() const { return mPath; }
  std::filesystem::path operator/(const std::filesystem::path& name) const { return mPath / name; }

 private:
  std::filesystem::path mPath;
};

}  // namespace velum
