#include "vector/WriteSvg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "core/ImageChannels.h"
#include "core/ReplaceFile.h"
#include "vector/Bounds.h"
#include "vector/Description.h"
#include "vector/Png.h"
#include "vector/Unicode.h"

namespace velum::vector {
namespace {

constexpr const char* kHead =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"
  xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" xmlns:cc="http://creativecommons.org/ns#"
  xmlns:dc="http://purl.org/dc/elements/1.1/" xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#"
  version="1.1" width="{0}mm" height="{1}mm" viewBox="0 0 {2} {3}">
{5}<metadata><rdf:RDF><cc:Work rdf:about=""><dc:format>image/svg+xml</dc:format><dc:title>{4}</dc:title>)"
    R"(<dc:creator><cc:Agent><dc:title>Velum</dc:title></cc:Agent></dc:creator></cc:Work></rdf:RDF>{6}</metadata>
)";

/// A number with as many digits as it needs, and no more behind the point than that.
std::string numberText(double value, int digits = 2) {
  std::string text = fmt::format("{:.{}f}", value, digits);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

/// A text that may stand between tags and in quotes.
std::string xmlText(std::string_view text) {
  std::string out;
  for (char c : cleanText(text)) switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  return out;
}

std::string colorText(const glm::vec3& color) {
  auto byte = [](float value) { return unsigned(wholeSample<std::uint8_t>(value)); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(color.r), byte(color.g), byte(color.b));
}

/// ` name-opacity="0.5"`, or nothing where all can be seen.
std::string opacityText(const char* name, double opacity) {
  return opacity >= 1.0 ? "" : fmt::format(" {}-opacity=\"{}\"", name, numberText(std::max(opacity, 0.0), 3));
}

std::string fillText(const glm::vec3& color, double opacity) {
  return fmt::format(" fill=\"{}\"{}", colorText(color), opacityText("fill", opacity));
}

std::string strokeText(const Pen& pen) {
  std::string dashes;
  if (hasDashes(pen))
    for (double dash : pen.dashes) dashes += (dashes.empty() ? "" : " ") + numberText(dash);
  return fmt::format(" stroke=\"{}\" stroke-width=\"{}\" stroke-linecap=\"round\" stroke-linejoin=\"round\"{}{}",
                     colorText(pen.color), numberText(pen.width, 3), opacityText("stroke", pen.opacity),
                     dashes.empty() ? "" : " stroke-dasharray=\"" + dashes + "\"");
}

constexpr double kPerPixel = 100.0;  // steps of numbers in paths

/// The attribute d of a path: as ways from place to place, which are short, and each from where rounding has led, so
/// that errors do not add up.
class PathText {
 public:
  void add(const Outline& outline) {
    begin('M', outline.start);
    glm::dvec2 from = outline.start;
    for (const Curve& curve : outline.curves) {
      bool isLast = &curve == &outline.curves.back();
      if (!isStraight(from, curve))
        go('c', {curve.control1, curve.control2, curve.end});
      else if (!isLast || !outline.isClosed || curve.end != outline.start)  // Z draws that
        go('l', {curve.end});
      from = curve.end;
    }
    if (outline.isClosed) command('Z');
  }
  std::string text() && { return std::move(mText); }

 private:
  static glm::dvec2 rounded(glm::dvec2 place) { return glm::round(place * kPerPixel) / kPerPixel; }
  void command(char letter) {
    if (letter != mCommand || letter == 'M') mText += letter;
    mCommand = letter;
  }
  void begin(char letter, glm::dvec2 place) {
    command(letter);
    mAt = rounded(place);
    put(mAt);
  }
  void go(char letter, std::initializer_list<glm::dvec2> places) {
    command(letter);
    for (glm::dvec2 place : places) put(rounded(place) - mAt);
    mAt = rounded(*(places.end() - 1));
  }
  void put(glm::dvec2 numbers) {
    for (double value : {numbers.x, numbers.y}) {
      std::string number = numberText(value);
      if (number.starts_with("0.")) number.erase(0, 1);
      if (number.starts_with("-0.")) number.erase(1, 1);
      bool isApart = number[0] == '-' || mText.back() == mCommand;
      mText += isApart ? number : ' ' + number;
    }
  }

  std::string mText;
  char mCommand = 0;
  glm::dvec2 mAt{0.0};
};

/// Outlines as the attribute d of a path.
std::string pathText(const std::vector<Outline>& outlines) {
  PathText path;
  for (const Outline& outline : outlines) path.add(outline);
  return std::move(path).text();
}

/// A drawing on its way into a text.
class SvgWriter {
 public:
  SvgWriter(const Drawing& drawing, std::string_view description);
  std::string takeText() { return std::move(mText); }

 private:
  template <class... Args>
  void put(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(mText), format, std::forward<Args>(args)...);
  }
  void write(const Layer& layer);
  void write(const Shape& shape);
  void write(const Words& words);
  void write(const Plate& plate);
  std::string idOf(std::string_view name, const char* other);

  std::string mText;
  std::set<std::string> mIds;
};

/// An id that nothing has yet, like a name. @param other  if the name has no letters that ids may have
std::string SvgWriter::idOf(std::string_view name, const char* other) {
  std::string id;
  for (char c : name) {
    bool isDigit = c >= '0' && c <= '9', isLetter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (isLetter || (isDigit && !id.empty()))
      id += c;
    else if (!id.empty() && id.back() != '-')
      id += '-';
  }
  while (!id.empty() && id.back() == '-') id.pop_back();
  if (id.empty()) id = other;
  std::string free = id;
  for (int turn = 2; !mIds.insert(free).second; ++turn) free = fmt::format("{}-{}", id, turn);
  return free;
}

void SvgWriter::write(const Shape& shape) {
  std::string id = idOf(shape.name, "line"), name = xmlText(shape.name);
  put("<path id=\"{}\"", id);
  if (!name.empty()) put(" inkscape:label=\"{}\"", name);
  put("{}{}",
      shape.fill ? fillText(shape.fill->color, shape.fill->opacity) + " fill-rule=\"evenodd\"" : " fill=\"none\"",
      shape.pen ? strokeText(*shape.pen) : "");
  put(" d=\"{}\"", pathText(shape.outlines));
  name.empty() ? put("/>\n") : put("><title>{}</title></path>\n", name);
}

void SvgWriter::write(const Words& words) {
  bool isBold = words.font == Font::SansBold || words.font == Font::SerifBold,
       isSerif = words.font == Font::Serif || words.font == Font::SerifBold;
  std::string id = idOf(words.text, "text"), fill = fillText(words.color, words.opacity);
  // The copy, too, inherits what is not said at the text itself: its fill.
  if (words.halo) put("<g{0}>\n<use xlink:href=\"#{1}\" fill=\"none\"{2}/>\n", fill, id, strokeText(*words.halo));
  put("<text id=\"{}\" x=\"{}\" y=\"{}\" font-family=\"{}\" font-size=\"{}\"{}{} xml:space=\"preserve\">{}</text>\n",
      id, numberText(words.start.x), numberText(words.start.y),
      isSerif ? "Liberation Serif, Times New Roman, Times, serif" : "Liberation Sans, Arial, Helvetica, sans-serif",
      numberText(words.em, 3), isBold ? " font-weight=\"bold\"" : "", words.halo ? "" : fill, xmlText(words.text));
  if (words.halo) put("</g>\n");
}

void SvgWriter::write(const Plate& plate) {
  put("<image id=\"{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" "
      "xlink:href=\"data:image/png;base64,",
      idOf("plate", "plate"), numberText(plate.low.x), numberText(plate.low.y), numberText(plate.size.x),
      numberText(plate.size.y));
  const bool hasAlpha = channelIndex(*plate.image, "A") >= 0;
  mText += base64Of(pngOf(*plate.image, hasAlpha ? Alpha::With : Alpha::Without));
  put("\"/>\n");
}

void SvgWriter::write(const Layer& layer) {
  put("<g id=\"{}\" inkscape:groupmode=\"layer\" inkscape:label=\"{}\"{}>\n", idOf("layer-" + layer.name, "layer"),
      xmlText(layer.name), layer.isHidden ? " style=\"display:none\"" : "");
  std::string_view group;
  for (const Item& item : layer.items) {
    if (!isDrawable(item)) continue;
    if (groupOf(item) != group) {
      if (!group.empty()) put("</g>\n");
      group = groupOf(item);
      if (!group.empty()) put("<g id=\"{}\" inkscape:label=\"{}\">\n", idOf(group, "group"), xmlText(group));
    }
    std::visit([&](const auto& one) { write(one); }, item);
  }
  if (!group.empty()) put("</g>\n");
  put("</g>\n");
}

SvgWriter::SvgWriter(const Drawing& drawing, std::string_view description) {
  expectDescription(description);
  const std::string title = xmlText(drawing.title);
  auto millimetres = [&](double pixels) { return numberText(pixels * 25.4 / drawing.dpi, 4); };
  put(fmt::runtime(kHead), millimetres(drawing.size.x), millimetres(drawing.size.y), numberText(drawing.size.x),
      numberText(drawing.size.y), title, title.empty() ? "" : "<title>" + title + "</title>\n",
      description.empty() ? "" : "\n" + svgDescription(description));
  for (const Layer& layer : drawing.layers) write(layer);
  put("</svg>\n");
}

}  // namespace

std::string svgOf(const Drawing& drawing, std::string_view description) {
  return SvgWriter(drawing, description).takeText();
}

void writeSvg(const Drawing& drawing, const std::filesystem::path& path, std::string_view description) {
  replaceFile(path, svgOf(drawing, description));
}

}  // namespace velum::vector
