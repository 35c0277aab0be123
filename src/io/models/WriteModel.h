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
/// Whether a path's ending is that of one of modelWriteFormats().
bool isModelWritten(const std::filesystem::path& path);

/// Choices for writing a model, beside the model itself.
struct ModelWriting {
  std::vector<glm::vec3> colors = {};       ///< sRGB, by type; empty: the file's own, grey where it has none
  const LevelSet* levels = nullptr;         ///< levels of this same model, for shapes; null: a ball for each molecule
  std::vector<std::uint32_t> numbers = {};  ///< number written for each instance; empty: 0, 1, 2, ...
  std::uint32_t mostBalls = 400;            ///< most balls of the level from which a shape is made, 1..1500
};

/// Writes a model, by extension; to a temporary beside it, then renamed:
///
/// - .cif, .cif.gz: mmCIF in the flavour of cellPACK, which readModel(), gemmi and Mol* read: an entity for each type,
///   an asym for each molecule, an operator for each instance. Beads become atoms without an element. Angstrom.
/// - .glb: glTF 2.0 with EXT_mesh_gpu_instancing: a mesh for each molecule, of the balls of a level; a node for each
///   type, named by its path. Points and places are in angstrom; the node above them turns them to y up and scales them
///   to one unit a nanometre, as asset.extras says: in glTF's metres a model would be too small to see.
/// - .csv: a line for each instance: type, compartment, number, place and rotation (w, x, y, z), middle and radius of
///   the ball around it, colour. Angstrom.
/// - .ply: binary points: the middles, with radius, rotation, colour, and numbers of type and instance. Angstrom.
/// @return what the format could not hold, one line each, for people
/// @throw InputError when the extension is not one of these, the model is empty, or the disk refuses; Cancelled
std::vector<std::string> writeModel(const Model& model, const std::filesystem::path& path, Progress& progress,
                                    const ModelWriting& how = {});

}  // namespace velum::io
