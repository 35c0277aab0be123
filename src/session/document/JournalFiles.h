#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// The files of a journal's folder: names, locks, reading. Functions that fail throw InputError in words.
namespace velum::session {

std::filesystem::path journalPath(const std::filesystem::path& folder, int generation);
std::filesystem::path autosavePath(const std::filesystem::path& folder, int generation);
/// The generations of which anything is there, newest first.
std::vector<int> generationsIn(const std::filesystem::path& folder);

/// Makes a folder and takes its lock. Nobody sees it before publishFolder().
/// @return descriptor of the lock
int makeLockedFolder(const std::filesystem::path& hidden);
/// Gives a folder its final name, under the same root.
void publishFolder(const std::filesystem::path& hidden, const std::filesystem::path& folder);

enum class LockKind { Shared, Exclusive };
/// Takes the lock of a folder. @return descriptor; -1 when another holds it, or there is none
int tryLock(const std::filesystem::path& folder, LockKind kind);

/// Empty when it cannot be read, or is larger than any journal.
std::string readWhole(const std::filesystem::path& path);

}  // namespace velum::session
