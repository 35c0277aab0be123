#pragma once
#include <glm/glm.hpp>

#include "core/Fields.h"

namespace velum::scene {

/// Phong with a soft hemisphere, one key light that casts shadows, and local ambient occlusion.
struct Lighting {
  bool shaded = true;                       ///< off: the transfer function's colours as they are
  double ambient = 0.35;                    ///< light from everywhere, brighter from above, 0..2
  double diffuse = 0.75;                    ///< key light, 0..2
  double specular = 0.25;                   ///< highlight of the key light, 0..2
  double shininess = 40.0;                  ///< Phong exponent of the highlight, 1..500
  glm::dvec3 keyDirection{-0.5, 0.6, 0.7};  ///< towards the key light, camera frame (x right, y up, z to the eye)
  double shadow = 0.6;                      ///< strength of shadows, 0..1
  double occlusion = 0.7;                   ///< strength of local ambient occlusion, 0..1
  double occlusionRadius = 0.06;            ///< reach of the occlusion, fraction of the volume's diameter, 0.005..0.3
  double fog = 0.0;                         ///< how far what lies deepest in a model fades into the background, 0..1
  bool operator==(const Lighting&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("shaded", o.shaded, FieldInfo{"", {}, "Off: the transfer function's colours as they are."});
    visit("ambient", o.ambient, FieldInfo{"", {0, 2}, "Light from everywhere, brighter from above."});
    visit("diffuse", o.diffuse, FieldInfo{"", {0, 2}, "Key light."});
    visit("specular", o.specular, FieldInfo{"", {0, 2}, "Highlight of the key light."});
    visit("shininess", o.shininess, FieldInfo{"", {1, 500}, "Phong exponent of the highlight."});
    visit("keyDirection", o.keyDirection, directionInfo("Towards the key light: x right, y up, z to the eye."));
    visit("shadow", o.shadow, FieldInfo{"", {0, 1}, "Strength of the shadows."});
    visit("occlusion", o.occlusion, FieldInfo{"", {0, 1}, "Strength of local ambient occlusion."});
    visit("occlusionRadius", o.occlusionRadius,
          FieldInfo{"", {0.005, 0.3}, "Reach of the occlusion, fraction of the volume's diameter."});
    visit("fog", o.fog, FieldInfo{"", {0, 1}, "How far what lies deepest in a model fades into the background.", true});
  }
};

/// What is behind everything.
struct Background {
  glm::vec3 top{0.16f, 0.18f, 0.21f};  ///< sRGB
  glm::vec3 bottom{0.05f, 0.055f, 0.065f};
  bool transparent = false;  ///< pictures get an alpha channel and no background
  bool operator==(const Background&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("top", o.top, FieldInfo{"", {0, 1}, "sRGB colour at the top."});
    visit("bottom", o.bottom, FieldInfo{"", {0, 1}, "sRGB colour at the bottom."});
    visit("transparent", o.transparent, FieldInfo{"", {}, "No background; pictures get an alpha channel."});
  }
};

}  // namespace velum::scene
