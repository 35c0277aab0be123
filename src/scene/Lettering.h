#pragma once
#include <string>
#include <vector>

#include "core/Fields.h"
#include "scene/Caption.h"

namespace velum::scene {

enum class Corner { TopLeft, TopRight, BottomLeft, BottomRight };

/// Most entries of a legend that a scene may list.
constexpr std::size_t kMostLegendEntries = 200;

/// What is written over a picture of the data: a legend of a model's types and of structures, a scale bar, the time of
/// the current time step, and captions.
struct Lettering {
  bool legend = false;
  std::vector<std::string> entries;  ///< paths of types and compartments, names of structures; empty: what is shown
  Corner legendCorner = Corner::TopLeft;
  bool scaleBar = false;
  Corner scaleBarCorner = Corner::BottomRight;
  bool timeStamp = false;
  Corner timeStampCorner = Corner::BottomLeft;
  std::vector<Caption> captions;
  double textSize = 18.0;  ///< of the letters (their em), pixels of a picture of 1000 rows, 4..100
  bool operator==(const Lettering&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("legend", o.legend,
          FieldInfo{"", {}, "On: colours and names of a model's types and of structures over the picture."});
    visit("entries", o.entries,
          FieldInfo{"",
                    {},
                    "What the legend names, in this order: paths of types, and of compartments as one entry each, "
                    "and names of structures; empty: the types that are seen most, and the structures that are shown.",
                    true,
                    false,
                    kMostLegendEntries});
    visit("legendCorner", o.legendCorner, FieldInfo{"", {}, "Where the legend stands."});
    visit("scaleBar", o.scaleBar,
          FieldInfo{"", {}, "On: a bar of a round length over the picture; in perspective at the camera's target."});
    visit("scaleBarCorner", o.scaleBarCorner, FieldInfo{"", {}, "Where the bar stands."});
    visit("timeStamp", o.timeStamp,
          FieldInfo{"", {}, "On: the time of the time step over the picture, or its number.", true});
    visit("timeStampCorner", o.timeStampCorner, FieldInfo{"", {}, "Where the time stands.", true});
    visit("captions", o.captions, FieldInfo{"", {}, "Words over the picture.", true, false, kMostCaptions});
    visit("textSize", o.textSize,
          FieldInfo{"pixel", {4, 100}, "Size of the letters in a picture of 1000 rows; others have it in proportion."});
  }
};

}  // namespace velum::scene

template <>
struct velum::EnumNames<velum::scene::Corner> {
  static constexpr std::string_view kNames[] = {"topLeft", "topRight", "bottomLeft", "bottomRight"};
};
