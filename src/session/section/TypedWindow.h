#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "scene/SceneFwd.h"

namespace velum::session {

/// The grey window that a text means: width and level in this order ("400 50", "400,50", "400/50"), or in any order
/// with their letters ("L 50 W 400", "W 300" alone), or a name of scene::greyWindowsFor() or the beginning of one
/// ("abdomen", "lu").
/// @param layer  whose window is to be set: level or width stay where the text does not name them
/// @return level and width, the volume's unit; nothing where the text is not understood, or the width is not above 0
std::optional<glm::dvec2> typedWindow(std::string_view text, const scene::VolumeLayer& layer);

/// What may be typed, for people: "width and level, as 400 50, or soft-tissue, abdomen, ...".
std::string typedWindowForms(const scene::VolumeLayer& layer);

/// A window as sections show it: "W 400  L 50 HU"; empty for colours and where there is no volume.
std::string windowText(const scene::VolumeLayer& layer);

}  // namespace velum::session
