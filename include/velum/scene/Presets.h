#pragma once
#include <span>
#include <string_view>

#include "velum/core/Volume.h"
#include "velum/scene/Scene.h"

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

/// Gives a layer and the lighting the look of a preset, fitted to the layer's volume.
/// @throw ArgumentError for an unknown name, listing the known ones
void applyPreset(Scene& scene, std::string_view name);

/// The preset that fits what the volume says of itself and, where it says nothing, its histogram. Never leaves the
/// picture empty or solid.
std::string_view choosePreset(const Volume& volume);

}  // namespace velum::scene
