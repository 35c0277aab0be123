#pragma once
#include <glm/glm.hpp>
#include <string>

#include "velum/core/Fields.h"

namespace velum::scene {

/// How one labelled structure is shown.
struct Structure {
  int id = 0;  ///< label, 1..65535
  std::string name;
  glm::vec3 color{1.0f};  ///< sRGB
  double opacity = 1.0;   ///< multiplies the transfer function's; alone, in a scene without a volume
  bool visible = true;
  double tint = 1.0;      ///< how far it takes its own colour, 0..1; multiplies LabelLayer::tint
  std::string litSphere;  ///< of a finished picture; empty: as Finish::sphere says
  bool operator==(const Structure&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("id", o.id, FieldInfo{"", {1, 65535}, "Label."});
    visit("name", o.name, FieldInfo{"", {}, "Name for people."});
    visit("color", o.color, FieldInfo{"", {0, 1}, "sRGB colour."});
    visit("opacity", o.opacity, FieldInfo{"", {0, 1}, "Factor on the opacity."});
    visit("visible", o.visible, FieldInfo{"", {}, "Off: the structure is not drawn."});
    visit("tint", o.tint, FieldInfo{"", {0, 1}, "How far it takes its own colour; a factor on the labels' tint."});
    visit("litSphere", o.litSphere,
          FieldInfo{"", {}, "Lit sphere of a finished picture; empty: that of the finish.", true});
  }
};

}  // namespace velum::scene
