#pragma once
#include <string>

#include "core/ReplaceFile.h"
#include "core/Task.h"
#include "io/read/Refuse.h"

namespace velum::io {

/// Writes all files of a folder into an archive as a store is kept in one (.ozx): stored as they are, with sizes of 64
/// bits, metadata first, of the folder itself before all. The caller commits the file.
/// @param without  a file that is left out  @param comment  of the archive
/// @throw InputError, Cancelled
void zipFolder(const Path& folder, const std::string& without, const std::string& comment, ReplaceFile& file,
               Progress& progress);

}  // namespace velum::io
