#include "vector/Bounds.h"

#include <algorithm>
#include <cmath>

#include "vector/Typeface.h"

namespace velum::vector {
namespace {

/// Beyond it no picture reaches, and Cairo does not count on.
constexpr double kFarthest = 1e6;

bool isPlace(glm::dvec2 at) { return std::abs(at.x) <= kFarthest && std::abs(at.y) <= kFarthest; }

bool isLength(double length) { return length > 0.0 && length <= kFarthest; }

bool isSound(const Outline& outline) {
  return isPlace(outline.start) && std::ranges::all_of(outline.curves, [](const Curve& curve) {
           return isPlace(curve.control1) && isPlace(curve.control2) && isPlace(curve.end);
         });
}

bool isTone(const glm::vec3& color, double opacity) {
  return std::isfinite(color.r) && std::isfinite(color.g) && std::isfinite(color.b) && std::isfinite(opacity);
}

bool isSound(const std::optional<Pen>& pen) {
  return !pen || (isLength(pen->width) && isTone(pen->color, pen->opacity));
}

bool isSound(const Shape& shape) {
  return (shape.pen || shape.fill) && isSound(shape.pen) &&
         (!shape.fill || isTone(shape.fill->color, shape.fill->opacity)) &&
         std::ranges::all_of(shape.outlines, [](const Outline& outline) { return isSound(outline); });
}

bool isSound(const Words& words) {
  return isLength(words.em) && isPlace(words.start) && isTone(words.color, words.opacity) && isSound(words.halo);
}

bool isSound(const Plate& plate) {
  return plate.image && plate.image->width > 0 && plate.image->height > 0 && isPlace(plate.low) &&
         isLength(plate.size.x) && isLength(plate.size.y);
}

/// Of an outline, piece by piece; the end of a closed one is at its start.
void addBoxes(const Outline& outline, double by, std::vector<Box>& boxes) {
  glm::dvec2 from = outline.start;
  auto add = [&](const Curve& curve) {
    Box box;
    for (glm::dvec2 at : {from, curve.control1, curve.control2, curve.end}) box.add(at);
    box.grow(by);
    boxes.push_back(box);
    from = curve.end;
  };
  for (const Curve& curve : outline.curves) add(curve);
  if (outline.isClosed) add(straight(from, outline.start));
}

Box unionOf(const std::vector<Box>& boxes) {
  Box all;
  for (const Box& box : boxes) all.add(box);
  return all;
}

std::vector<Box> boxesOfSound(const Shape& shape, Typefaces&) {
  std::vector<Box> boxes;
  for (const Outline& outline : shape.outlines) addBoxes(outline, shape.pen ? 0.5 * shape.pen->width : 0.0, boxes);
  if (shape.fill && !boxes.empty()) boxes = {unionOf(boxes)};
  return boxes;
}

std::vector<Box> boxesOfSound(const Words& words, Typefaces& faces) {
  Typeface& face = *faces.of(words.font);
  Box all;
  for (const Glyph& glyph : face.glyphs(words.text)) {
    std::vector<Box> boxes;
    for (const Outline& outline : face.outlinesOf(glyph.index)) addBoxes(outline, 0.0, boxes);
    Box box = unionOf(boxes);
    if (box.isEmpty()) continue;
    glm::dvec2 start = words.start + glm::dvec2(glyph.x * words.em, 0.0);
    all.add(Box{start + words.em * box.low, start + words.em * box.high});
  }
  if (all.isEmpty()) return {};
  all.grow(words.halo ? 0.5 * words.halo->width : 0.0);
  return {all};
}

std::vector<Box> boxesOfSound(const Plate& plate, Typefaces&) { return {{plate.low, plate.low + plate.size}}; }

}  // namespace

bool isDrawable(const Item& item) {
  return std::visit([](const auto& sound) { return isSound(sound); }, item);
}

bool hasDashes(const Pen& pen) {
  bool areLengths = std::ranges::all_of(pen.dashes, [](double dash) { return dash >= 0.0 && dash <= kFarthest; });
  return areLengths && std::ranges::any_of(pen.dashes, [](double dash) { return dash > 0.0; });
}

std::vector<Box> boxesOf(const Item& item, Typefaces& faces) {
  if (!isDrawable(item)) return {};
  return std::visit([&](const auto& sound) { return boxesOfSound(sound, faces); }, item);
}

Box boundsOf(std::span<const Item> items) {
  Typefaces faces;
  Box all;
  for (const Item& item : items) all.add(unionOf(boxesOf(item, faces)));
  return all;
}

}  // namespace velum::vector
