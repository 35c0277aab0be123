#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "scene/SceneFwd.h"

namespace velum::session {

/// The grey window that a text means: width and level in this order ("400 50", "400,50", "400/50"), by their letters in
/// any ("L 50 W 400", "W 300" alone), or a name of scene::greyWindowsFor() or its beginning ("abdomen", "lu").
/// @param layer  whose window it is to be: what is not named stays
/// @return level and width, the volume's unit; nothing where it is not understood, or the width is not above 0
std::optional<glm::dvec2> typedWindow(std::string_view text, const scene::VolumeLayer& layer);

/// What may be typed, for people: "width and level, as 400 50, or soft-tissue, abdomen, ...".
std::string typedWindowForms(const scene::VolumeLayer& layer);

/// A window as it stands on sections: "W 400  L 50 HU"; empty for colours and where there is no volume.
std::string windowText(const scene::VolumeLayer& layer);

}  // namespace velum::session
