#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/Mesh.h"
#include "core/Units.h"

namespace velum::io {

/// One row of the table of formats that surfaces are written in.
struct MeshFormat {
  std::string_view name;       ///< "glTF"
  std::string_view extension;  ///< ".glb"
  bool keepsNames;             ///< keeps the names of several surfaces in one file
};
/// For file dialogs, `--help` and the docs.
std::span<const MeshFormat> meshFormats();

/// Checks, before the surfaces are made, that their path has an extension that can be written. @throw InputError when
/// the extension is unknown
void expectMeshFormat(const std::filesystem::path& path);

/// Writes .obj, .ply (binary), .vtp, .stl (binary) or .glb (glTF 2.0), by extension; to a temporary beside it, then
/// renamed. Points are in LPS and in the unit of the mesh, which no format can name; .glb has a transform to metres
/// with y up. The name is written for other programs, and so is the colour, except to .vtp and .stl.
/// @return what the format could not hold, one line each, for people
/// @throw InputError when the extension is not one of these, the mesh is empty, or the disk refuses
std::vector<std::string> writeMesh(const Mesh& mesh, const std::filesystem::path& path,
                                   LengthUnit unit = LengthUnit::Millimetre);

/// Writes several surfaces to one file: in .glb and .obj each with its own name and colour, in .ply with its own
/// colour; in .stl and .vtp they are joined to one surface.
std::vector<std::string> writeMeshes(std::span<const Mesh> meshes, const std::filesystem::path& path,
                                     LengthUnit unit = LengthUnit::Millimetre);

}  // namespace velum::io
