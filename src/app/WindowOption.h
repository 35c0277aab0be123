#pragma once
#include <string>
#include <string_view>

#include "scene/SceneFwd.h"

/// The option --window.
namespace velum::app {

/// What --window sets, among what --set does: level and width together.
inline constexpr std::string_view kWindowField = "volume.window";

/// Names of grey windows with their units, for the help.
std::string windowNames();
/// Sets the grey window of a layer by a name or by numbers. @throw ArgumentError for what means none, with what would
void setGreyWindow(scene::VolumeLayer& layer, const std::string& text);

}  // namespace velum::app
