#pragma once
#include <span>

#include "core/Mesh.h"
#include "core/ReplaceFile.h"
#include "core/Units.h"

namespace velum::io {

/// Writes glTF 2.0, binary: a node with mesh, material and name for each surface. The points are in our world and unit;
/// the node above them turns our axes (left, posterior, superior) to glTF's (x, -z, y) and scales lengths to metres.
/// @throw InputError when the surfaces do not fit into 4 GB. The caller commits.
void writeGltf(std::span<const Mesh> meshes, LengthUnit unit, ReplaceFile& file);

}  // namespace velum::io
