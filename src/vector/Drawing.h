#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/Fields.h"
#include "core/Image.h"
#include "core/Shared.h"

/// A picture that stays lines and letters: what is written over a plate, in named layers. Lengths and places are in
/// pixels of the picture for which the drawing is made, from its top left corner, x to the right, y down.
namespace velum::vector {

/// One piece of an outline, a cubic Bezier curve from where the piece before it ended.
struct Curve {
  glm::dvec2 control1, control2, end;
};

/// A line made of pieces.
struct Outline {
  glm::dvec2 start{0.0};
  std::vector<Curve> curves;
  bool isClosed = false;
};

/// A piece that is straight.
inline Curve straight(glm::dvec2 from, glm::dvec2 to) {
  return {glm::mix(from, to, 1.0 / 3.0), glm::mix(from, to, 2.0 / 3.0), to};
}
/// True where a piece lies on its chord.
bool isStraight(glm::dvec2 from, const Curve& curve);
/// A line through points. @param points  at least one
Outline outlineThrough(const std::vector<glm::dvec2>& points, bool isClosed);
/// A circle of four pieces.
Outline circle(glm::dvec2 middle, double radius);
/// A rectangle with round corners. @param left, right  radii of the corners there
Outline rectangle(glm::dvec2 low, glm::dvec2 high, double left, double right);
inline Outline rectangle(glm::dvec2 low, glm::dvec2 high, double radius) {
  return rectangle(low, high, radius, radius);
}

/// How a line is drawn; with round ends and joins.
struct Pen {
  glm::vec3 color{0.0f};       ///< sRGB
  double width = 1.0;          ///< pixels, > 0
  double opacity = 1.0;        ///< 0..1
  std::vector<double> dashes;  ///< lengths of strokes and gaps, in turn, pixels; empty: none
};

struct Fill {
  glm::vec3 color{0.0f};  ///< sRGB
  double opacity = 1.0;   ///< 0..1
};

/// Outlines that are filled by the even-odd rule, then stroked.
struct Shape {
  std::string name;  ///< of what it belongs to, as a structure, for people; empty: nothing
  std::vector<Outline> outlines;
  std::optional<Pen> pen;
  std::optional<Fill> fill;
  std::string group;  ///< shapes of a layer that follow each other and have the same are a group in files, which has
                      ///< this name and can be selected at once, as the lines of a compartment; empty: none
};

/// Fonts that are part of the program.
enum class Font { Sans, SansBold, Serif, SerifBold };

/// One line of text that stays text.
struct Words {
  std::string text;       ///< UTF-8
  glm::dvec2 start{0.0};  ///< of the base line
  double em = 12.0;       ///< size of the letters, pixels, > 0
  Font font = Font::Sans;
  glm::vec3 color{0.0f};  ///< sRGB
  double opacity = 1.0;
  std::optional<Pen> halo;  ///< stroked along the letters before they are filled
};

/// A picture of pixels.
struct Plate {
  Shared<Image> image;             ///< R, G, B and, where it is transparent, A with straight alpha, 0..1, sRGB
  glm::dvec2 low{0.0}, size{0.0};  ///< where it lies
};

using Item = std::variant<Plate, Shape, Words>;
/// Of a shape; empty for the others.
std::string_view groupOf(const Item& item);

/// What users switch on and off together.
struct Layer {
  std::string name;         ///< "contours"
  std::vector<Item> items;  ///< in the order in which they are drawn
  bool isHidden = false;    ///< files have it switched off; pictures are without it
};

struct Drawing {
  glm::dvec2 size{0.0};       ///< pixels
  double dpi = 300.0;         ///< pixels an inch on the page, > 0
  std::string title;          ///< UTF-8; empty: none
  std::vector<Layer> layers;  ///< in the order in which they are drawn
};

}  // namespace velum::vector

template <>
struct velum::EnumNames<velum::vector::Font> {
  static constexpr std::string_view kNames[] = {"sans", "sansBold", "serif", "serifBold"};
};
