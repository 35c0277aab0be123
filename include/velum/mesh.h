#pragma once
#include "core/Mesh.h"
#include "io/meshes/ReadMesh.h"
#include "io/meshes/WriteMesh.h"

/// Mesh: a surface of triangles. Also reads and writes files of meshes.
namespace velum {

using io::readMesh;
using io::writeMesh;
using io::writeMeshes;

}  // namespace velum
