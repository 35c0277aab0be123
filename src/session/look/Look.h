#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "scene/SceneFwd.h"

namespace velum::session {

/// True for files that importLook() reads, told by their names: .velum-transfer.json, and 3D Slicer's .vp.json and .vp.
bool isLookFile(const std::filesystem::path& path);

/// Gives the scene the transfer function of a file. Where several channels are mixed the current channel gets it, and
/// keeps its colour where the file has none. Light and window stay. The scene is drawn as a volume from then on.
/// @return what the file has that the scene does not take, one line each, for people
/// @throw InputError for a file that is missing, damaged or of another kind; the scene is then unchanged
std::vector<std::string> importLook(scene::Scene& scene, const std::filesystem::path& path);

/// Writes the transfer function that is being edited, in the format that the file's name says.
/// @return what the format could not hold, one line each, for people. @throw InputError
std::vector<std::string> exportLook(const scene::Scene& scene, const std::filesystem::path& path);

/// Writes the transfer function of a scene file, a picture of ours or a file of a look to `output`; the scene's data is
/// not read.
/// @return what was lost on the way, one line each, for people. @throw InputError
std::vector<std::string> convertLook(const std::filesystem::path& input, const std::filesystem::path& output);

}  // namespace velum::session
