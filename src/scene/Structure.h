#pragma once
#include <glm/glm.hpp>
#include <string>
#include <string_view>

#include "core/Fields.h"

namespace velum::scene {

/// What a structure that is not hidden looks like beside a volume.
enum class ShowAs { Material, Solid };

/// How one labelled structure is shown.
struct Structure {
  int id = 0;  ///< label, 1..65535
  std::string name;
  glm::vec3 color{1.0f};  ///< sRGB
  double opacity = 1.0;   ///< of material: multiplies the transfer function's; solid: of its surface
  bool visible = true;
  double tint = 1.0;                 ///< how far the structure takes its own colour, 0..1; multiplies LabelLayer::tint
  std::string litSphere;             ///< of a finished picture; empty: as Finish::sphere says
  ShowAs showAs = ShowAs::Material;  ///< its values by the transfer function, or a closed surface of its colour; alone,
                                     ///< in a scene without a volume, it is always a surface
  double smoothing = 0.0;  ///< of its shape in the file: standard deviation of a Gaussian, a length; 0: as it is there
  std::string fileId;      ///< its number in the file where that is another (LabelInfo::fileId), in decimal digits
  bool operator==(const Structure&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("id", o.id, FieldInfo{"", {1, 65535}, "Label."});
    visit("name", o.name, FieldInfo{"", {}, "Name for people."});
    visit("color", o.color, FieldInfo{"", {0, 1}, "sRGB colour."});
    visit("showAs", o.showAs,
          FieldInfo{
              "", {}, "As material, its values by the transfer function, or solid, a surface of its colour.", true});
    visit("opacity", o.opacity, FieldInfo{"", {0, 1}, "Material: a factor on its opacity; solid: its surface's."});
    visit("visible", o.visible, FieldInfo{"", {}, "Off: the structure is not drawn."});
    visit("tint", o.tint, FieldInfo{"", {0, 1}, "How far it takes its own colour; a factor on the labels' tint."});
    visit("smoothing", o.smoothing,
          FieldInfo{kLength, {0, 1e6}, "How far its shape is smoothed: a Gaussian's standard deviation.", true});
    visit("fileId", o.fileId,
          FieldInfo{"", {}, "Its number in the file of the labels, where that is not its id.", true});
    visit("litSphere", o.litSphere,
          FieldInfo{"", {}, "Lit sphere of a finished picture; empty: that of the finish.", true});
  }
};

}  // namespace velum::scene

template <>
struct velum::EnumNames<velum::scene::ShowAs> {
  static constexpr std::string_view kNames[] = {"material", "solid"};
};
