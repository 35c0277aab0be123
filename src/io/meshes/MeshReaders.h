#pragma once
#include "core/Mesh.h"
#include "core/Task.h"
#include "io/read/Refuse.h"

/// The readers, each in the file of its name. The table in ReadMesh.cpp names them and chooses.
/// Each compares every count with what is left of the file before it allocates, every index with the points, and
/// refuses points that are no numbers. It gives triangles, and normals as the file has them, or none; the rest is
/// readMesh()'s. They throw InputError with the file's name and the reason.
namespace velum::io {

Mesh readPly(const Path& path, Progress& progress);
Mesh readStl(const Path& path, Progress& progress);
Mesh readObj(const Path& path, Progress& progress);
Mesh readVtp(const Path& path, Progress& progress);

}  // namespace velum::io
