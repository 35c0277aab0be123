#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace velum::io {

/// The data files that a NRRD or MetaImage header names: one file, "LIST" with @p listLines, or a printf pattern with
/// first, last and step ("slice%03d.raw 1 20 1"). All files must lie within the header's folder. @throw InputError
std::vector<std::filesystem::path> namedDataFiles(const std::filesystem::path& header, const std::string& value,
                                                  const std::string& listLines);

}  // namespace velum::io
