#pragma once
#include <filesystem>

#include "scene/SceneFwd.h"

namespace velum::gui {

/// Writes a scene into velum's folder under XDG_DATA_HOME, named after its contents, so that a command line that names
/// the file keeps meaning this scene. @return the file  @throw InputError when the disk refuses
std::filesystem::path keepScene(const scene::Scene& scene);

}  // namespace velum::gui
