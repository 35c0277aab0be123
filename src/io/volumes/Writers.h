#pragma once
#include <string>
#include <utility>
#include <vector>

#include "io/read/Refuse.h"
#include "io/volumes/Readers.h"

namespace velum::io {

/// What the label writer adds to what writeNrrd and writeNifti do.
struct LabelExtras {
  std::vector<std::pair<std::string, std::string>> nrrdKeyValues;
  std::string niftiExtension;  ///< XML, empty for none; its presence also marks the file as labels.
  int changedNames = 0;        ///< Of structures, to fit the format.
};
std::vector<std::string> writeNrrdWith(const Volume& volume, ReplaceFile& file, const LabelExtras& extras,
                                       Progress& progress);
std::vector<std::string> writeNiftiWith(const Volume& volume, ReplaceFile& file, const LabelExtras& extras,
                                        Progress& progress);

/// @throw InputError when the volume lacks samples
void checkWhole(const Volume& volume, const Path& path);
/// Of the name: a file is called by its own where it holds none.
bool isNameLost(const Volume& volume, const Path& path);

}  // namespace velum::io
