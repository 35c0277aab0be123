#pragma once
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/Levels.h"
#include "core/Model.h"
#include "core/Task.h"

namespace velum::io {

/// One row of the table of formats that models are written in.
struct ModelWriteFormat {
  std::string_view name;        ///< "glTF"
  std::string_view extensions;  ///< ".cif .cif.gz"
};
/// For file dialogs, `--help` and the docs.
std::span<const ModelWriteFormat> modelWriteFormats();
/// The ending is one of theirs.
bool isModelWritten(const std::filesystem::path& path);

/// What the formats take of a model beside what it holds.
struct ModelWriting {
  std::vector<glm::vec3> colors = {};       ///< sRGB, by type; empty: the file's own, grey where it has none
  const LevelSet* levels = nullptr;         ///< of this very model: shapes; null: a ball each
  std::vector<std::uint32_t> numbers = {};  ///< by which points name instances; empty: 0 and on
  std::uint32_t mostBalls = 400;            ///< of the level of which a shape is made, 1..1500
};

/// Writes a model, by extension; to a temporary beside it, then renamed:
///
/// - .cif, .cif.gz: mmCIF in the flavour of cellPACK, which readModel(), gemmi and Mol* read: an entity for each type,
/// an
///   asym for each molecule, an operator for each instance. Beads become atoms without an element. Angstrom.
/// - .glb: glTF 2.0 with EXT_mesh_gpu_instancing: a mesh for each molecule, of the balls of a level; a node for each
///   type, named by its path. Points and places are in angstrom; the node above them turns them to y up and scales to
///   one unit a nanometre, which asset.extras says: of glTF's metres nothing would be seen.
/// - .csv: a line for each instance: type, compartment, number, place and rotation (w, x, y, z), middle and radius of
///   the ball around it, colour. Angstrom.
/// - .ply: binary points: the middles, with radius, rotation, colour, and numbers of type and instance. Angstrom.
/// @return what the format could not hold, one line each, for people
/// @throw InputError when the extension is not one of these, the model is empty, or the disk refuses; Cancelled
std::vector<std::string> writeModel(const Model& model, const std::filesystem::path& path, Progress& progress,
                                    const ModelWriting& how = {});

}  // namespace velum::io
