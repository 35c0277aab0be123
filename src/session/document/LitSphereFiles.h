#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/Image.h"
#include "core/Shared.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// Reads a user's picture of a lit sphere: the largest square in its middle, which the sphere fills to its edges.
/// @throw InputError when there is none, or it is no picture
Shared<Image> readLitSphere(const std::filesystem::path& path);

/// Reads the pictures of a scene's own lit spheres that the scene does not hold yet. Paths are taken relative to
/// `folder`. A sphere whose picture cannot be read looks like porcelain.
/// @return a line for each picture that is missing or bad, and for each sphere that the scene names but that nobody has
std::vector<std::string> loadLitSpheres(scene::Scene& scene, const std::filesystem::path& folder);

/// Adds a user's picture to a scene's lit spheres, named after its file. A picture that the scene has already is read
/// anew.
/// @return the sphere's name
/// @throw InputError as readLitSphere()
std::string addLitSphere(scene::Scene& scene, const std::filesystem::path& path);

}  // namespace velum::session
