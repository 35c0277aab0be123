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
/// The numbers of the generations of which a journal or an autosave is there, newest first. @param error  why the
/// folder cannot be listed to its end
std::vector<int> generationsIn(const std::filesystem::path& folder, std::error_code& error);

/// Makes a folder and takes its lock. Nobody who looks for journals sees the folder before publishFolder(). Where this
/// fails no folder is left. @return descriptor of the lock
int makeLockedFolder(const std::filesystem::path& hidden);
/// Gives a folder its final name, under the same root.
void publishFolder(const std::filesystem::path& hidden, const std::filesystem::path& folder);
/// Deletes a folder. Those who look for lost work stop seeing it at once, even if this process dies while deleting.
/// @return why the folder is there still
std::error_code removeFolder(const std::filesystem::path& folder);
/// True for a folder that removeFolder() has begun to delete.
bool isBeingRemoved(const std::filesystem::path& folder);

enum class LockKind { Shared, Exclusive };
/// What came of taking a lock.
struct LockTry {
  int descriptor = -1;  ///< to be closed by the caller; -1: the lock was not taken
  std::string whyNot;   ///< why the system refuses, in words; empty with descriptor -1: another process holds the lock
  bool isTaken() const { return descriptor >= 0; }
  bool isHeld() const { return descriptor < 0 && whyNot.empty(); }
};
/// Tries to take the lock of a folder. Where the lock's file is missing, the folder itself is locked in its stead; so
/// is something that is no folder.
LockTry tryLock(const std::filesystem::path& folder, LockKind kind);

/// What was read of a file.
struct FileText {
  std::string text;    ///< as far as it could be read
  std::string whyNot;  ///< what stopped the reading, in words; empty too when there is no such file
};
/// Reads the first bytes of a file. Waits for nothing. @param most  as many bytes as are read at most
FileText readFile(const std::filesystem::path& path, std::size_t most);
/// Reads a small file such as a list of files; empty when it cannot be read, or is larger than such a list can be.
std::string readWhole(const std::filesystem::path& path);

}  // namespace velum::session
