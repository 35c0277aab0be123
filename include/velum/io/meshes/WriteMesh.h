#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "velum/core/Mesh.h"

namespace velum::io {

/// Writes .obj, .ply (binary), .vtp or .stl (binary), by extension; to a temporary beside it, then renamed.
/// LPS, in the unit that the mesh is in, which no format names. The name goes along for other programs.
/// @return what the format could not hold, one line each, for people
/// @throw InputError when the extension is not one of these, the mesh is empty, or the disk refuses
std::vector<std::string> writeMesh(const Mesh& mesh, const std::filesystem::path& path);

}  // namespace velum::io
