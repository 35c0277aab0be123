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
/// Scenes, volumes, models, surfaces, and pictures of ours with a scene inside, in the order of menus.
std::vector<FilePatterns> readablePatterns();
/// Volumes only; files with labels have the same formats.
std::vector<FilePatterns> volumePatterns();
/// The formats in which files of a kind are written, the usual format first.
std::vector<FilePatterns> writtenPatterns(io::FileKind kind);

}  // namespace velum::session
