#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/Fields.h"
#include "scene/Ids.h"

namespace velum::scene {

/// Most captions in a scene; addCaption() and files keep to this limit.
constexpr std::size_t kMostCaptions = 100;

/// Nine places of a picture, row by row.
enum class CaptionPlace { TopLeft, Top, TopRight, Left, Centre, Right, BottomLeft, Bottom, BottomRight };

/// Words over a picture. Captions at one place stand below each other, in their order.
struct Caption {
  int id = 0;        ///< number by which the caption is known: from 1, unique in a scene, see addCaption(); 0: none yet
  std::string text;  ///< UTF-8, lines with line ends between them
  CaptionPlace place = CaptionPlace::Bottom;
  double size = 1.0;               ///< of its letters, in those of Lettering::textSize, 0.2..20
  std::optional<glm::vec3> color;  ///< sRGB; none: as other lettering, dark on light and light on dark
  double opacity = 1.0;            ///< 0 (takes no room either)..1
  bool operator==(const Caption&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("id", o.id,
          FieldInfo{"", {0, kMostId}, "Number by which the caption is known, unique in a scene; 0: a new one."});
    visit("text", o.text, FieldInfo{"", {}, "The words, with line ends between lines; long lines are broken."});
    visit("place", o.place, FieldInfo{"", {}, "Where it stands; captions at one place stand below each other."});
    visit("size", o.size, FieldInfo{"", {0.2, 20}, "Size of its letters, in that of other lettering.", true});
    visit("color", o.color,
          FieldInfo{"", {0, 1}, "sRGB colour; null: as other lettering, dark on light and light on dark.", true});
    visit("opacity", o.opacity, FieldInfo{"", {0, 1}, "Opacity; at 0 it takes no room either.", true});
  }
};

/// Appends a caption under a new id, whatever id it had. @return the new id
/// @throw ArgumentError where there are kMostCaptions
int addCaption(std::vector<Caption>& captions, Caption caption);

}  // namespace velum::scene

template <>
struct velum::EnumNames<velum::scene::CaptionPlace> {
  static constexpr std::string_view kNames[] = {"topLeft", "top",        "topRight", "left",       "centre",
                                                "right",   "bottomLeft", "bottom",   "bottomRight"};
};
