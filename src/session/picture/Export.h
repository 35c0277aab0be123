#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/Task.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// Files of a scene whose membranes are at rest, their shapes in it (see settleMembranes), for other programs.

/// Writes the sheets of cuts as surfaces: .obj, .ply, .vtp or .stl, by extension. One to the path, several to
/// NAME-0.ply, NAME-1.ply. @param cuts  ids of membranes. @throw InputError as io::writeMesh
/// @return what the format could not hold, one line each, for people
std::vector<std::string> exportSheets(const scene::Scene& settled, const std::vector<int>& cuts,
                                      const std::filesystem::path& path);

/// Writes the volume with what the cuts remove emptied: .nrrd, .nii, .nii.gz, .vti or .vdb. @throw Cancelled,
/// InputError as io::writeVolume, ArgumentError without a volume. @return as exportSheets()
std::vector<std::string> exportClippedVolume(const scene::Scene& settled, const std::filesystem::path& path,
                                             Progress& progress);

}  // namespace velum::session
