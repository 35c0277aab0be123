#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/SceneFwd.h"

namespace velum::session {

/// Gives a scene a user's picture of paper, with the path of its file.
/// @throw InputError when there is no such file, or it is no picture
void takePaper(scene::Scene& scene, const std::filesystem::path& path);

/// Reads the picture of a scene's own paper, unless the scene holds the picture already or names none. The path is
/// taken relative to `folder`. Where the picture cannot be read the paper is smooth.
/// @return a line that says so
std::optional<std::string> loadPaper(scene::Scene& scene, const std::filesystem::path& folder);

/// Reads the paper and the lit spheres that are the user's own, as loadPaper() and loadLitSpheres() do.
/// @return lines that say what could not be read
std::vector<std::string> loadOwnPictures(scene::Scene& scene, const std::filesystem::path& folder);

}  // namespace velum::session
