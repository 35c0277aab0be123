#pragma once
#include <filesystem>

#include "velum/core/Mesh.h"

namespace velum::io {

/// Writes .obj, .ply (binary), .vtp or .stl (binary), by extension; to a temporary beside it, then renamed.
/// Millimetres, LPS.
/// @throw InputError when the extension is not one of these, the mesh is empty, or the disk refuses
void writeMesh(const Mesh& mesh, const std::filesystem::path& path);

}  // namespace velum::io
