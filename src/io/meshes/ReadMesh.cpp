#include "io/meshes/ReadMesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <new>
#include <stdexcept>

#include "io/meshes/MeshParts.h"
#include "io/meshes/MeshReaders.h"
#include "io/read/FileNames.h"
#include "io/read/Refuse.h"

/// Surfaces. The files have no frame of their own; their numbers are taken as millimetres in LPS, as 3D Slicer and
/// ITK-SNAP write them.
namespace velum::io {

namespace {

struct MeshReader {
  std::string_view extension;
  Mesh (*read)(const Path&, Progress&);
};
// A new format is one row.
constexpr MeshReader kReaders[] = {{".stl", readStl}, {".ply", readPly}, {".obj", readObj}, {".vtp", readVtp}};

}  // namespace

std::span<const std::string_view> meshExtensions() {
  static constexpr auto kExtensions = [] {
    std::array<std::string_view, std::size(kReaders)> all;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = kReaders[i].extension;
    return all;
  }();
  return kExtensions;
}

Mesh readMesh(const Path& path, Progress& progress) try {
  progress.report(0, "reading surface");
  std::string extension = lowerExtension(path);
  auto reader = std::find_if(std::begin(kReaders), std::end(kReaders),
                             [&](const MeshReader& row) { return row.extension == extension; });
  if (reader == std::end(kReaders))
    refuse(path, fmt::format("surfaces are read from {}, not '{}'", fmt::join(meshExtensions(), ", "), extension));
  Mesh mesh = reader->read(path, progress);
  if (mesh.indices.empty()) refuse(path, "has no triangles");
  completeNormals(mesh);
  mesh.name = titleOf(path);
  progress.report(1, "reading surface");
  return mesh;
} catch (const std::bad_alloc&) {
  refuse(path, "needs more memory than there is");
} catch (const std::length_error&) {
  refuse(path, "is damaged (a length in it makes no sense)");
}

}  // namespace velum::io
