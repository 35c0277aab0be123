#pragma once
#include <filesystem>

namespace velum::io {

/// Writes sound files for the targets of sources, and of drawings, into folders of their names.
void writeSourceSeeds(const std::filesystem::path& root);

}  // namespace velum::io
