#pragma once
#include <initializer_list>
#include <optional>

#include "scene/NamedTable.h"
#include "scene/Presets.h"

namespace velum::scene {

/// What a relative preset takes as 0 and 1 in a volume.
enum class Ends {
  Background,  ///< The background, and the brightest share of what is not background.
  BothTails,   ///< The outermost four thousandths on either side: amplitudes round zero, or no background at all.
};

/// A row of the table of presets: all that makes a preset. Values are as in Preset.
struct PresetRow {
  Preset preset;
  std::initializer_list<ColorPoint> colors;
  /// Opacity per mm when the preset is absolute, per voxel when relative.
  std::initializer_list<OpacityPoint> opacities;
  double windowLevel, windowWidth;  ///< For sections.
  double specular;
  Ends ends = Ends::Background;
  double brightShare = 0.01;                 ///< Share of the values above the background that counts as fully bright.
  bool isProjection = false;                 ///< The largest value along a ray shows, in its colour.
  std::optional<glm::vec3> background = {};  ///< Of the picture; none: as it was.
};

/// All presets, in the order of menus.
const NamedTable<PresetRow, Preset>& presetTable();

}  // namespace velum::scene
