#pragma once
#include <filesystem>

/// Where things of the user belong by the XDG Base Directory Specification. A variable that is empty or relative does
/// not count. Nothing is created here.
namespace velum::session {

/// Work that must survive: $XDG_STATE_HOME/velum.
std::filesystem::path stateFolder();
/// What can be made again: $XDG_CACHE_HOME/velum.
std::filesystem::path cacheFolder();
/// Where journals lie, a folder for each document that is open: stateFolder()/recovery.
std::filesystem::path recoveryFolder();

}  // namespace velum::session
