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
  bool operator==(const Structure&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("id", o.id, FieldInfo{"", {1, 65535}, "Label."});
    visit("name", o.name, FieldInfo{"", {}, "Name for people."});
    visit("color", o.color, FieldInfo{"", {0, 1}, "sRGB colour."});
    visit("opacity", o.opacity, FieldInfo{"", {0, 1}, "Factor on the opacity."});
    visit("visible", o.visible, FieldInfo{"", {}, "Off: the structure is not drawn."});
  }
};

}  // namespace velum::scene
