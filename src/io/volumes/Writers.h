#pragma once
#include <string>
#include <utility>
#include <vector>

#include "io/read/Refuse.h"
#include "io/volumes/Readers.h"

namespace velum::io {

/// What the label writer adds to the files of writeNrrd and writeNifti.
struct LabelExtras {
  std::vector<std::pair<std::string, std::string>> nrrdKeyValues;
  std::string niftiExtension;  ///< XML, empty for none; its presence also marks the file as labels.
  int changedNames = 0;        ///< How many names of structures were changed to fit the format.
};
std::vector<std::string> writeNrrdWith(const Volume& volume, ReplaceFile& file, const LabelExtras& extras,
                                       Progress& progress);
std::vector<std::string> writeNiftiWith(const Volume& volume, ReplaceFile& file, const LabelExtras& extras,
                                        Progress& progress);

/// @throw InputError when the volume lacks samples
void checkWhole(const Volume& volume, const Path& path);
/// True when writing to the path loses the volume's name: a file that holds no name is known by its file name, which
/// differs.
bool isNameLost(const Volume& volume, const Path& path);

}  // namespace velum::io
