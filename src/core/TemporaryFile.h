#pragma once
#include <filesystem>
#include <string>

namespace velum {

struct TemporaryFile {
  int descriptor = -1;  ///< Open for writing and locked while its process lives; -1: errno says why not.
  std::string name;     ///< In its folder.
};

/// A new file under a name that nobody can guess: others who may write to the folder can neither wait for it nor put a
/// link in its way. Before the first in a folder, what killed processes of ours left there is removed: it is known by
/// its name, and nobody holds its lock. Any thread.
/// @param name  of the file that it will become; the end of it is kept
/// @param mode  before the umask
TemporaryFile makeTemporaryFile(const std::filesystem::path& folder, const std::string& name, unsigned mode);

}  // namespace velum
