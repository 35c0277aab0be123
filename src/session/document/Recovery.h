#pragma once
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "scene/SceneFwd.h"

/// Finding and reading what the journals (session/document/Journal.h) of dead sessions have left behind.
namespace velum::session {

/// Work of a session that has died.
struct LostWork {
  std::filesystem::path folder;
  std::string title;                           ///< what was open
  std::string scenePath;                       ///< file of the scene; empty: it was never saved
  std::string label;                           ///< the last change
  std::chrono::system_clock::time_point when;  ///< of the last change
  bool isReadable = true;
  bool isWhole = true;  ///< false: the last changes are damaged, and what can be read is older
  std::string whyNot;   ///< why the work is not readable, or not whole: which file, and what is wrong with the file
};

/// The work of all dead sessions, newest first, also work that cannot be read. Sessions that live, or whose work
/// another process is taking, are not listed. Any thread; takes milliseconds for each.
/// @param root  the folder with the journals' folders  @throw InputError when `root` is there and cannot be read
std::vector<LostWork> findLostWork(const std::filesystem::path& root);

/// Holds the lock on the work of a dead session, so that no other process takes the work.
class WorkClaim {
 public:
  /// @throw InputError when the work is gone, its session lives, or another process holds the work
  explicit WorkClaim(std::filesystem::path folder);
  ~WorkClaim();
  WorkClaim(const WorkClaim&) = delete;
  WorkClaim& operator=(const WorkClaim&) = delete;

  /// The newest scene that can be read from the work, without its data. @throw InputError when there is none
  scene::Scene readScene() const;
  /// Deletes the work: it is safe elsewhere, or not wanted. @throw InputError when it cannot be deleted
  void remove();

 private:
  std::filesystem::path mFolder;
  int mLock = -1;
};

}  // namespace velum::session
