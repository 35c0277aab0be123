#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/Fields.h"

namespace velum::scene {

/// A stop of the colour curve.
struct ColorPoint {
  double value = 0;       ///< data value, the volume's unit
  glm::vec3 color{1.0f};  ///< sRGB, 0..1
  bool operator==(const ColorPoint&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("value", o.value, FieldInfo{"", {}, "Data value."});
    visit("color", o.color, FieldInfo{"", {0, 1}, "sRGB colour."});
  }
};

/// A point of an opacity curve; between points it is linear, beyond the ends it stays.
struct OpacityPoint {
  double value = 0;    ///< data value, or gradient magnitude (value per unit of length of the scene)
  double opacity = 0;  ///< 0..1 for `unitDistance` of material
  bool operator==(const OpacityPoint&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("value", o.value, FieldInfo{"", {}, "Data value, or gradient magnitude (value per unit of length)."});
    visit("opacity", o.opacity, FieldInfo{"", {0, 1}, "Opacity of unitDistance of material."});
  }
};

/// What data looks like: colour and opacity by value, opacity also by gradient magnitude.
struct TransferFunction {
  std::string preset;                           ///< name of the preset that the function was made from, for people
  std::vector<ColorPoint> colors;               ///< ascending by value
  std::vector<OpacityPoint> opacities;          ///< ascending by value
  std::vector<OpacityPoint> gradientOpacities;  ///< ascending; multiplies; empty: 1 everywhere
  double unitDistance = 1.0;                    ///< thickness to which the opacities apply, > 0
  bool operator==(const TransferFunction&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("preset", o.preset, FieldInfo{"", {}, "Preset that it was made from."});
    visit("colors", o.colors, FieldInfo{"", {}, "Colour by data value."});
    visit("opacities", o.opacities, FieldInfo{"", {}, "Opacity by data value."});
    visit("gradientOpacities", o.gradientOpacities,
          FieldInfo{"", {}, "Factor by gradient magnitude; empty: 1 everywhere."});
    visit("unitDistance", o.unitDistance,
          FieldInfo{kLength, {1e-9, 1e9}, "Thickness of material to which the opacities apply."});
  }
};

/// One channel of a volume that has several (fluorescence dyes): all that are visible are mixed in one picture.
struct ChannelLook {
  std::string name;
  bool visible = true;
  glm::vec3 color{1.0f};      ///< sRGB; its colour on sections and in lists
  TransferFunction transfer;  ///< its colour and opacity in the 3D picture
  double windowLevel = 0.0;   ///< middle of its grey window on sections, the volume's unit
  double windowWidth = 0.0;   ///< its width; 0: the whole range
  bool operator==(const ChannelLook&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("name", o.name, FieldInfo{"", {}, "Name for people: the dye."});
    visit("visible", o.visible, FieldInfo{"", {}, "Off: the channel is not mixed in."});
    visit("color", o.color, FieldInfo{"", {0, 1}, "sRGB colour on sections and in lists."});
    visit("transfer", o.transfer, FieldInfo{"", {}, "Colour and opacity by value in the 3D picture."});
    visit("windowLevel", o.windowLevel, FieldInfo{"", {}, "Middle of the window on sections."});
    visit("windowWidth", o.windowWidth, FieldInfo{"", {0, 1e300}, "Width of the window; 0: the whole range."});
  }
};

/// Opacity at a value, 0..1: linear between points, constant beyond them, 0 without any.
double opacityAt(const std::vector<OpacityPoint>& points, double value);
/// Colour at a value in the same way; white without any.
glm::dvec3 colorAt(const std::vector<ColorPoint>& points, double value);

}  // namespace velum::scene
