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
  bool keepsNames;             ///< Of several surfaces in one file.
};
/// For file dialogs, `--help` and the docs.
std::span<const MeshFormat> meshFormats();

/// The format of surfaces that are to be written, before there are any. @throw InputError when the extension is unknown
void expectMeshFormat(const std::filesystem::path& path);

/// Writes .obj, .ply (binary), .vtp, .stl (binary) or .glb (glTF 2.0), by extension; to a temporary beside it, then
/// renamed. LPS, in the unit that the mesh is in, which no format names; .glb holds how it lies in metres with y up.
/// The name goes along for other programs, and the colour but to .vtp and .stl.
/// @return what the format could not hold, one line each, for people
/// @throw InputError when the extension is not one of these, the mesh is empty, or the disk refuses
std::vector<std::string> writeMesh(const Mesh& mesh, const std::filesystem::path& path,
                                   LengthUnit unit = LengthUnit::Millimetre);

/// The same with several surfaces in one file: of names and colours of their own in .glb and .obj, of colours of their
/// own in .ply, joined to one in .stl and .vtp.
std::vector<std::string> writeMeshes(std::span<const Mesh> meshes, const std::filesystem::path& path,
                                     LengthUnit unit = LengthUnit::Millimetre);

}  // namespace velum::io
