#pragma once

#include <filesystem>

namespace velum::io {

/// Walks a PLY file by its header and looks at every face: VTK's reader believes the counts and indices that it meets.
/// @throw InputError when the header is damaged, the file ends early or a face names a vertex that is not there
void checkPly(const std::filesystem::path& path);

}  // namespace velum::io
