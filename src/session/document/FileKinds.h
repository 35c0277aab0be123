#pragma once
#include <string>
#include <vector>

#include "io/kinds/FileKind.h"

namespace velum::session {

/// Files of one format, as dialogs offer them.
struct FilePatterns {
  std::string name;                   ///< "NIfTI"
  std::vector<std::string> patterns;  ///< "*.nii", "*.nii.gz"
};
/// Scenes, volumes, models, surfaces, pictures of ours, in the order of menus.
std::vector<FilePatterns> readablePatterns();
/// Volumes only; labels come in files of the same formats.
std::vector<FilePatterns> volumePatterns();
/// The formats in which a kind is written, the usual one first.
std::vector<FilePatterns> writtenPatterns(io::FileKind kind);

}  // namespace velum::session
