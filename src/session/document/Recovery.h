#pragma once
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "scene/SceneFwd.h"

/// Reading what journals (session/Journal.h) have left behind.
namespace velum::session {

/// Work of a session that has died.
struct LostWork {
  std::filesystem::path folder;
  std::string title;                           ///< what was open
  std::string scenePath;                       ///< file of the scene; empty: it was never saved
  std::string label;                           ///< the last change
  std::chrono::system_clock::time_point when;  ///< of the last change
  bool isReadable = true;
  bool isWhole = true;  ///< false: its last changes are damaged, what can be read is older
  std::string whyNot;   ///< why it is not readable, or not whole: which file, and what is wrong with it
};

/// The work of all dead sessions, newest first, also what cannot be read. Sessions that live, or whose work another
/// process is taking, are not listed. Any thread; takes milliseconds for each.
/// @throw InputError when that folder is there and cannot be read
std::vector<LostWork> findLostWork(const std::filesystem::path& root);

/// Holds dead work, so that nobody else takes it.
class WorkClaim {
 public:
  /// @throw InputError when it is gone, its session lives, or another holds it
  explicit WorkClaim(std::filesystem::path folder);
  ~WorkClaim();
  WorkClaim(const WorkClaim&) = delete;
  WorkClaim& operator=(const WorkClaim&) = delete;

  /// The newest scene that can be read, without its data. @throw InputError when there is none
  scene::Scene readScene() const;
  /// Deletes it: it is safe elsewhere, or not wanted. @throw InputError when it cannot be deleted
  void remove();

 private:
  std::filesystem::path mFolder;
  int mLock = -1;
};

}  // namespace velum::session
