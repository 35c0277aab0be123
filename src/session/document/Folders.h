#pragma once
#include <filesystem>

/// Where files of the user belong by the XDG Base Directory Specification. An environment variable that is empty or
/// relative does not count. Nothing is created here.
namespace velum::session {

/// For work that must survive: $XDG_STATE_HOME/velum.
std::filesystem::path stateFolder();
/// For what can be made again: $XDG_CACHE_HOME/velum.
std::filesystem::path cacheFolder();
/// For levels of detail of models: cacheFolder()/levels.
std::filesystem::path levelFolder();
/// Where journals lie, a folder for each document that is open: stateFolder()/recovery.
std::filesystem::path recoveryFolder();

}  // namespace velum::session
