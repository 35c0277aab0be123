#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace velum::io {

/// The text of a NRRD header, taken apart but not yet understood.
struct NrrdHeader {
  std::filesystem::path file;
  std::map<std::string, std::string> fields;     ///< "field: value", names in lower case.
  std::map<std::string, std::string> keyValues;  ///< "key:=value", as written.
  std::string dataFileList;                      ///< Lines after "data file: LIST".
  std::uint64_t headerBytes = 0;                 ///< Where attached data starts.
  /// Value of a field that may be spelled in two ways; empty where the header has neither.
  std::string field(const char* name, const char* otherName = "") const;
};

/// @throw InputError when the file is not a NRRD, or its header does not end within 4 MiB
NrrdHeader readNrrdHeader(const std::filesystem::path& file);

}  // namespace velum::io
