#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/Task.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// Files for other programs, of a scene whose membranes are at rest and that holds the shapes of their sheets (see
/// settleMembranes()).

/// Writes the sheets of cuts as surfaces: .obj, .ply, .vtp or .stl, by extension. A single sheet goes to the path,
/// several go to NAME-0.ply, NAME-1.ply and so on. @param cuts  ids of membranes. @throw InputError as io::writeMesh
/// @return what the format could not hold, one line each, for people
std::vector<std::string> exportSheets(const scene::Scene& settled, const std::vector<int>& cuts,
                                      const std::filesystem::path& path);

/// Writes the volume with the part that the cuts remove emptied: .nrrd, .nii, .nii.gz, .vti, .vdb, .zarr or .ozx.
/// @throw Cancelled, InputError as io::writeVolume, ArgumentError without a volume. @return as exportSheets()
std::vector<std::string> exportClippedVolume(const scene::Scene& settled, const std::filesystem::path& path,
                                             Progress& progress);

}  // namespace velum::session
