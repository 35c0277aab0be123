#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/Task.h"
#include "render/SheetIndices.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// What was written of a model.
struct ModelExport {
  std::size_t types = 0, instances = 0;
  std::vector<std::string> losses;  ///< what the file does not hold, one line each, for people
};

/// Writes what shows of a scene's model: the instances that its cuts leave of types that are not hidden, in their
/// colours. The extension says how, see io::writeModel(): .cif, .cif.gz, .glb, .csv, .ply. Points have the numbers of
/// the whole model's instances, as render::Pick::modelInstance and the mattes of pictures have them.
/// @param sheets  of membranes that move; other membranes have the shapes that the scene holds
/// @throw InputError where there is no model, no part of it shows, the extension is none of these, or the disk refuses;
/// Cancelled. Any thread.
ModelExport exportModel(const scene::Scene& scene, const std::filesystem::path& path, Progress& progress,
                        const render::SheetIndices& sheets = {});

/// True for the extensions in which models are written. Extensions of surfaces (.glb, .ply) are among them.
bool isModelFile(const std::filesystem::path& path);

}  // namespace velum::session
