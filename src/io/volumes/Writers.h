#pragma once
#include <string>
#include <utility>
#include <vector>

#include "Readers.h"

namespace velum::io {

/// What the label writer adds to what writeNrrd and writeNifti do.
struct LabelExtras {
  std::vector<std::pair<std::string, std::string>> nrrdKeyValues;
  std::string niftiExtension;  ///< XML, empty for none; its presence also marks the file as labels.
};
void writeNrrdWith(const Volume& volume, ReplaceFile& file, const LabelExtras& extras, Progress& progress);
void writeNiftiWith(const Volume& volume, ReplaceFile& file, const LabelExtras& extras, Progress& progress);

}  // namespace velum::io
