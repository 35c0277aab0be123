#pragma once
#include <optional>
#include <span>
#include <string_view>

#include "core/Volume.h"
#include "scene/Scene.h"

namespace velum::scene {

/// A named look. Values are data values (Hounsfield units) when `isAbsolute`, else fractions of the way from the
/// background of this volume (0) to its brightest thousandth (1).
struct Preset {
  std::string_view name;   ///< "ct-bone"
  std::string_view title;  ///< "CT: bone"
  Modality modality;
  bool isAbsolute;
};

/// Every preset, in the order of menus.
std::span<const Preset> presets();

/// Gives a layer and the lighting the look of a preset, fitted to the layer's volume; where channels are mixed, only
/// the current channel gets the look, and keeps its colour.
/// @throw ArgumentError for an unknown name, listing the known ones
void applyPreset(Scene& scene, std::string_view name);

/// Whether a preset shows a projection: the largest value along a ray shows in its colour.
bool isProjectionLook(std::string_view name);

/// Whether a preset is for data that is solid material everywhere, like the ground, so that the data's box is the
/// object.
bool isAllMaterial(std::string_view preset);

/// The preset that fits what the volume says of itself and, where it says nothing, its histogram. Never leaves the
/// picture empty.
std::string_view choosePreset(const Volume& volume);

/// Where a volume has several channels and the layer has no looks for them yet: gives each channel a look of its own,
/// fitted to its values. Colours that the colour-blind can tell apart come first.
void completeChannels(VolumeLayer& layer);

/// The values between which the file shows a channel; nothing where it says none, or a window that chooses nothing, as
/// it holds all values or none.
std::optional<glm::dvec2> fileWindow(const Volume& volume, int channel);

/// Gives a channel a colour: on sections, and the ramp from dark to it in the 3D picture.
void colorChannel(ChannelLook& look, glm::vec3 color);

}  // namespace velum::scene
