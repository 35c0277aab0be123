#pragma once
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>

#include "core/Volume.h"
#include "scene/SceneFwd.h"

namespace velum::scene {

/// A grey window with a name, suited to a kind of tissue.
struct GreyWindow {
  std::string_view name;   ///< "abdomen"
  std::string_view title;  ///< "Abdomen"
  std::string_view unit;   ///< unit of its level and width: "HU", "SUVbw"
  double level, width;
};

/// All grey windows, in the order of menus.
std::span<const GreyWindow> greyWindows();
/// The grey windows that suit the values of a volume; none where the unit of the values is unknown.
std::span<const GreyWindow> greyWindowsFor(const Volume& volume);

/// The unit of a volume's values: what its file says, or HU where the values look like those of a CT. Empty: unknown.
std::string valueUnit(const Volume& volume);

/// Sets the window of a layer by name. @throw ArgumentError for an unknown name, or a window for another unit of values
void applyGreyWindow(VolumeLayer& layer, std::string_view name);

/// Level and width in which new data is first seen on sections, chosen from the values; width 0 where a preset's window
/// fits. CT: the soft tissue, the vessels where a contrast medium fills much of it, or the bone where there is little
/// else. PET: from nothing to what a hundredth of the body exceeds, and at least to three times its mean, so that a
/// full bladder darkens nothing.
glm::dvec2 firstWindow(const Volume& volume);

}  // namespace velum::scene
