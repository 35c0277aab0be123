#pragma once
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/FileName.h"
#include "io/read/Refuse.h"

/// What readers ask of names of files and of folders.
namespace velum::io {

/// Name for people: the file's without its ending (".seg.nrrd" and ".nii.gz" go whole), the folder's as it is.
std::string titleOf(const Path& path);

/// "slice2" before "slice10": runs of digits compare as numbers.
bool naturalLess(std::string_view a, std::string_view b);

/// Regular files of a folder that are not hidden, in natural order of their names.
std::vector<Path> filesInOrder(const Path& folder);

/// The other half of a pair: the file of the same name with one of these endings, the first that is there. A ".gz" of
/// the file's own name does not count.
std::optional<Path> fileBeside(const Path& file, std::initializer_list<const char*> endings);

/// A file that a header names, taken relative to the header. Headers come from strangers, so the file must lie in the
/// header's folder or below, and be a regular file. @throw InputError
Path siblingFile(const Path& header, std::string_view name);

}  // namespace velum::io
