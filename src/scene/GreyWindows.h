#pragma once
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>

#include "core/Volume.h"
#include "scene/SceneFwd.h"

namespace velum::scene {

/// A grey window by name: what a kind of tissue is looked at with.
struct GreyWindow {
  std::string_view name;   ///< "abdomen"
  std::string_view title;  ///< "Abdomen"
  std::string_view unit;   ///< that its numbers are in: "HU", "SUVbw"
  double level, width;
};

/// All of them, in the order of menus.
std::span<const GreyWindow> greyWindows();
/// Those for the values of a volume; none where nobody knows what these mean.
std::span<const GreyWindow> greyWindowsFor(const Volume& volume);

/// The unit of a volume's values: what its file says, or HU where they give themselves away as a CT's. Empty: unknown.
std::string valueUnit(const Volume& volume);

/// Sets the window of a layer by name. @throw ArgumentError for a name that there is not, or that is of other values
void applyGreyWindow(VolumeLayer& layer, std::string_view name);

/// Level and width in which new data is first seen on sections, from what it holds; width 0 where a preset's window
/// fits. CT: the soft tissue, the vessels where a contrast medium fills much of it, or the bone where there is little
/// else. PET: from nothing to what a hundredth of the body exceeds, and at least to three times its mean, so that
/// a full bladder darkens nothing.
glm::dvec2 firstWindow(const Volume& volume);

}  // namespace velum::scene
