#include "session/document/Folders.h"

#include <pwd.h>
#include <unistd.h>

#include <cstdlib>

namespace velum::session {

namespace fs = std::filesystem;

namespace {

fs::path home() {
  if (const char* path = std::getenv("HOME"); path && *path) return path;
  const passwd* user = ::getpwuid(::getuid());
  return user && user->pw_dir ? fs::path(user->pw_dir) : fs::temp_directory_path();
}

fs::path xdgFolder(const char* variable, const char* fallback) {
  const char* path = std::getenv(variable);
  fs::path base = path && *path == '/' ? fs::path(path) : home() / fallback;
  return base / "velum";
}

}  // namespace

fs::path stateFolder() { return xdgFolder("XDG_STATE_HOME", ".local/state"); }
fs::path cacheFolder() { return xdgFolder("XDG_CACHE_HOME", ".cache"); }
fs::path levelFolder() { return cacheFolder() / "levels"; }
fs::path recoveryFolder() { return stateFolder() / "recovery"; }

}  // namespace velum::session
