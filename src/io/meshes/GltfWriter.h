#pragma once
#include <span>

#include "core/Mesh.h"
#include "core/ReplaceFile.h"
#include "core/Units.h"

namespace velum::io {

/// glTF 2.0, binary: a node with mesh, material and name for each surface. The points are in our world and unit; the
/// node above them turns it (left, posterior, superior) to glTF's (x, -z, y) and scales it to metres.
/// @throw InputError when they do not fit into 4 GB. The caller commits.
void writeGltf(std::span<const Mesh> meshes, LengthUnit unit, ReplaceFile& file);

}  // namespace velum::io
