#pragma once
#include <string>
#include <vector>

namespace velum::session {

/// A kind of file that can be opened, for dialogs and help.
struct FileKind {
  std::string name;                   ///< "NIfTI"
  std::vector<std::string> patterns;  ///< "*.nii", "*.nii.gz"
};
/// Scenes, volumes, surfaces, pictures of ours, in the order of menus.
std::vector<FileKind> readableKinds();
/// Volumes only; labels come in files of the same kinds.
std::vector<FileKind> volumeKinds();

}  // namespace velum::session
