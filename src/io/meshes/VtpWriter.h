#pragma once
#include "core/Mesh.h"
#include "core/ReplaceFile.h"

namespace velum::io {

/// Writes VTK's PolyData, .vtp. The caller commits. @throw InputError
void writeVtp(const Mesh& mesh, ReplaceFile& file);

}  // namespace velum::io
