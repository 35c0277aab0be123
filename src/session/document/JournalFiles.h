#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

/// The files of a journal's folder: names, locks, reading, removing. Functions that fail throw InputError in words.
namespace velum::session {

std::filesystem::path journalPath(const std::filesystem::path& folder, int generation);
std::filesystem::path autosavePath(const std::filesystem::path& folder, int generation);
/// The generations of which anything is there, newest first. @param error  why the folder cannot be listed to its end
std::vector<int> generationsIn(const std::filesystem::path& folder, std::error_code& error);

/// Makes a folder and takes its lock. Nobody sees it before publishFolder(). Where it fails nothing is left.
/// @return descriptor of the lock
int makeLockedFolder(const std::filesystem::path& hidden);
/// Gives a folder its final name, under the same root.
void publishFolder(const std::filesystem::path& hidden, const std::filesystem::path& folder);
/// Deletes a folder, at once for those who look for work, whenever the process dies. @return why it is there still
std::error_code removeFolder(const std::filesystem::path& folder);
/// One that removeFolder() has begun with.
bool isBeingRemoved(const std::filesystem::path& folder);

enum class LockKind { Shared, Exclusive };
/// What came of taking a lock.
struct LockTry {
  int descriptor = -1;  ///< to be closed; -1: not taken
  std::string whyNot;   ///< the system refuses, in words; empty with -1: another holds it
  bool isTaken() const { return descriptor >= 0; }
  bool isHeld() const { return descriptor < 0 && whyNot.empty(); }
};
/// Takes the lock of a folder; where its file is missing, the folder stands for it. Something that is no folder is
/// locked itself.
LockTry tryLock(const std::filesystem::path& folder, LockKind kind);

/// What was read of a file.
struct FileText {
  std::string text;    ///< as far as it could be read
  std::string whyNot;  ///< what came in between, in words; empty too when there is no such file
};
/// The first bytes of a file. Waits for nothing. @param most  as many as are read
FileText readFile(const std::filesystem::path& path, std::size_t most);
/// Empty when it cannot be read, or is larger than a list of files can be.
std::string readWhole(const std::filesystem::path& path);

}  // namespace velum::session
