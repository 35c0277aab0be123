#pragma once
#include <filesystem>
#include <string>

namespace velum {

struct TemporaryFile {
  int descriptor = -1;  ///< Open for writing, locked while the process lives; -1: not made, errno says why.
  std::string name;     ///< File name, without its folder.
};

/// Makes a new file under a name that nobody can guess, so that other users who may write to the folder can neither
/// wait for the file nor put a link in its place. Before the first such file in a folder, temporaries that killed
/// processes of ours left there are removed: they are known by their names, and nobody holds their locks. Any thread.
/// @param name  name of the file that the temporary will become; the temporary's name keeps its end
/// @param mode  permissions of the file, before the umask is applied
TemporaryFile makeTemporaryFile(const std::filesystem::path& folder, const std::string& name, unsigned mode);

}  // namespace velum
