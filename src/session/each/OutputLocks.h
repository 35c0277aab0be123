#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace velum::session {

/// A name that a file has because of its whole path, such as "0f3a...-p1.png": no other path has it.
/// @param path  absolute
std::string nameOfWholePath(const std::filesystem::path& path);

/// The files that a piece is written to, held so that no other process writes one of them, whatever it calls them and
/// whatever else it makes. A lock is a file beside the output, ".velum-lock-...": it ends with the process, however
/// that ends; the file is removed with this object, and what a killed process has left of it by the next one that takes
/// it.
class OutputLocks {
 public:
  /// Takes all of them or none, in one order everywhere, and waits for nobody: of processes that want some of the same
  /// files one gets all of its own. Makes the outputs' folders. @return nothing while another process has one of the
  /// files  @throw InputError when the disk refuses
  static std::optional<OutputLocks> take(const std::vector<std::filesystem::path>& outputs);
  OutputLocks(OutputLocks&& other) noexcept : mHeld(std::exchange(other.mHeld, {})) {}
  OutputLocks& operator=(OutputLocks&&) = delete;
  ~OutputLocks();

 private:
  struct Held {
    std::filesystem::path file;
    int descriptor;
  };
  OutputLocks() = default;
  std::vector<Held> mHeld;
};

}  // namespace velum::session
