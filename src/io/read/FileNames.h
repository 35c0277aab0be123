#pragma once
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/FileName.h"
#include "io/read/Refuse.h"

/// Questions that readers ask about the names of files and folders.
namespace velum::io {

/// A name for people: the file's name without its ending (".seg.nrrd" and ".nii.gz" are dropped as a whole), a folder's
/// name as it is.
std::string titleOf(const Path& path);

/// "slice2" before "slice10": runs of digits compare as numbers.
bool naturalLess(std::string_view a, std::string_view b);

/// Regular files of a folder that are not hidden, in natural order of their names.
std::vector<Path> filesInOrder(const Path& folder);

/// The other half of a pair of files: the file with the same name and one of these endings, the first that exists. A
/// ".gz" at the end of the given file's name is ignored.
std::optional<Path> fileBeside(const Path& file, std::initializer_list<const char*> endings);

/// The path of a file that a header names, relative to the header. Headers come from strangers, so the file must lie in
/// the header's folder or below, and be a regular file. @throw InputError
Path siblingFile(const Path& header, std::string_view name);

}  // namespace velum::io
