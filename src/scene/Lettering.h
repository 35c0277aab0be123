#pragma once
#include <string>
#include <vector>

#include "core/Fields.h"
#include "scene/Caption.h"
#include "scene/Mark.h"

namespace velum::scene {

enum class Corner { TopLeft, TopRight, BottomLeft, BottomRight };

/// Most entries of a legend that a scene may list.
constexpr std::size_t kMostLegendEntries = 200;

/// Letters that are part of the program.
enum class Typeface { Sans, Serif };

/// Where names stand that find their own places: in columns left and right of what is seen, or around it.
enum class NameOrder { Columns, Around };

/// Most names that find their own places in a picture.
constexpr int kMostNames = 100;

/// What is written over a picture of the data: a legend of a model's types and of structures, a scale bar, the time of
/// the current time step, captions, marks, and the names of what is seen.
struct Lettering {
  bool legend = false;
  std::vector<std::string> entries;  ///< paths of types and compartments, names of structures; empty: what is shown
  Corner legendCorner = Corner::TopLeft;
  bool scaleBar = false;
  Corner scaleBarCorner = Corner::BottomRight;
  bool timeStamp = false;
  Corner timeStampCorner = Corner::BottomLeft;
  std::vector<Caption> captions;
  std::vector<Mark> marks;
  bool names = false;              ///< of structures and types that are seen, beside marks of their own
  std::vector<std::string> named;  ///< as `entries`; empty: what is seen most
  int mostNames = 20;              ///< that find their own places, 1..kMostNames
  NameOrder nameOrder = NameOrder::Columns;
  double textSize = 18.0;    ///< of the letters (their em), pixels of a picture of 1000 rows, 4..100; without a page
  double pageWidth = 0.0;    ///< of the printed picture, mm; 0: it has none, and sizes go with the picture's rows
  double textPoints = 7.0;   ///< of the letters on the page, points (1/72 inch)
  double linePoints = 0.75;  ///< width of lines on the page, points; without a page in proportion to the letters
  Typeface typeface = Typeface::Sans;
  bool bold = false;
  std::optional<glm::vec3> color;  ///< sRGB; none: dark on light and light on dark
  double halo = 1.0;               ///< how much of the ground's colour lies around letters and lines, 0..1
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
    visit("marks", o.marks,
          FieldInfo{"", {}, "Measures, arrows, labels: written beside places in the world.", true, false, kMostMarks});
    visit("names", o.names,
          FieldInfo{"", {}, "On: names of the structures and types that are seen, with leaders to them.", true});
    visit("named", o.named,
          FieldInfo{"",
                    {},
                    "What is named, as the legend's entries; empty: what is seen most.",
                    true,
                    false,
                    kMostLegendEntries});
    visit("mostNames", o.mostNames, FieldInfo{"", {1, kMostNames}, "How many are named at most.", true});
    visit("nameOrder", o.nameOrder, FieldInfo{"", {}, "Where the names stand: in columns, or around.", true});
    visit("textSize", o.textSize,
          FieldInfo{"pixel", {4, 100}, "Size of the letters in a picture of 1000 rows; others have it in proportion."});
    visit("pageWidth", o.pageWidth,
          FieldInfo{"mm", {0, 5000}, "Width of the printed picture; 0: sizes go with the picture's rows.", true});
    visit("textPoints", o.textPoints,
          FieldInfo{"point", {1, 200}, "Size of the letters on the page, where the picture has a page's width.", true});
    visit("linePoints", o.linePoints,
          FieldInfo{"point", {0.1, 20}, "Width of lines on the page; without one in proportion to the letters.", true});
    visit("typeface", o.typeface, FieldInfo{"", {}, "Letters with serifs or without.", true});
    visit("bold", o.bold, FieldInfo{"", {}, "On: heavy letters.", true});
    visit("color", o.color,
          FieldInfo{"", {0, 1}, "sRGB colour of all lettering; null: dark on light and light on dark.", true});
    visit("halo", o.halo,
          FieldInfo{"", {0, 1}, "How much of the ground's colour lies around letters and lines.", true});
  }
};

}  // namespace velum::scene

template <>
struct velum::EnumNames<velum::scene::Corner> {
  static constexpr std::string_view kNames[] = {"topLeft", "topRight", "bottomLeft", "bottomRight"};
};
template <>
struct velum::EnumNames<velum::scene::Typeface> {
  static constexpr std::string_view kNames[] = {"sans", "serif"};
};
template <>
struct velum::EnumNames<velum::scene::NameOrder> {
  static constexpr std::string_view kNames[] = {"columns", "around"};
};
