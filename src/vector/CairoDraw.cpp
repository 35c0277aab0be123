#include "vector/CairoDraw.h"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>

#include "core/Error.h"
#include "vector/Bounds.h"
#include "vector/PlateBytes.h"
#include "vector/Typeface.h"

namespace velum::vector {
namespace {

constexpr int kMostPixels = 32'767;  // of an image of Cairo, along each axis

/// Adds the outlines of a text.
void addLetters(cairo_t* cairo, const Words& words, Typeface& face) {
  cairo_matrix_t before;
  cairo_get_matrix(cairo, &before);
  for (const Glyph& glyph : face.glyphs(words.text)) {
    cairo_translate(cairo, words.start.x + glyph.x * words.em, words.start.y);
    cairo_scale(cairo, words.em, words.em);
    for (const Outline& outline : face.outlinesOf(glyph.index)) addOutline(cairo, outline);
    cairo_set_matrix(cairo, &before);
  }
}

}  // namespace

void setColor(cairo_t* cairo, const glm::vec3& color, double opacity) {
  cairo_set_source_rgba(cairo, color.r, color.g, color.b, opacity);
}

void addOutline(cairo_t* cairo, const Outline& outline) {
  cairo_move_to(cairo, outline.start.x, outline.start.y);
  glm::dvec2 from = outline.start;
  for (const Curve& curve : outline.curves) {
    if (isStraight(from, curve))
      cairo_line_to(cairo, curve.end.x, curve.end.y);
    else
      cairo_curve_to(cairo, curve.control1.x, curve.control1.y, curve.control2.x, curve.control2.y, curve.end.x,
                     curve.end.y);
    from = curve.end;
  }
  if (outline.isClosed) cairo_close_path(cairo);
}

void strokeWith(cairo_t* cairo, const Pen& pen) {
  setColor(cairo, pen.color, pen.opacity);
  cairo_set_line_width(cairo, pen.width);
  cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
  cairo_set_dash(cairo, pen.dashes.data(), hasDashes(pen) ? int(pen.dashes.size()) : 0, 0.0);
  cairo_stroke(cairo);
}

void drawShape(cairo_t* cairo, const Shape& shape) {
  for (const Outline& outline : shape.outlines) addOutline(cairo, outline);
  if (shape.fill) {
    setColor(cairo, shape.fill->color, shape.fill->opacity);
    cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_EVEN_ODD);
    cairo_fill_preserve(cairo);
  }
  if (shape.pen) strokeWith(cairo, *shape.pen);
  cairo_new_path(cairo);
}

void drawHalo(cairo_t* cairo, const Words& words, Typeface& face) {
  if (!words.halo) return;
  addLetters(cairo, words, face);
  // Of 16 samples a pixel: a quarter of the time, and nobody looks for the edge of a halo.
  cairo_set_antialias(cairo, CAIRO_ANTIALIAS_FAST);
  strokeWith(cairo, *words.halo);
  cairo_set_antialias(cairo, CAIRO_ANTIALIAS_DEFAULT);
}

void drawLetters(cairo_t* cairo, const Words& words, Typeface& face) {
  drawHalo(cairo, words, face);
  addLetters(cairo, words, face);
  setColor(cairo, words.color, words.opacity);
  cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_WINDING);
  cairo_fill(cairo);
}

void drawPlate(cairo_t* cairo, const Plate& plate) {
  const Image& image = *plate.image;
  if (image.width > kMostPixels || image.height > kMostPixels)
    throw ArgumentError("a plate has at most 32767 pixels along each axis: make it smaller");
  std::vector<std::uint8_t> rgba = plateBytes(image, Alpha::With);
  std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo_image_surface_create(CAIRO_FORMAT_ARGB32, image.width, image.height), cairo_surface_destroy);
  auto* rows = cairo_image_surface_get_data(surface.get());
  if (!rows) return expectDrawn(cairo);
  const std::size_t stride = std::size_t(cairo_image_surface_get_stride(surface.get()));
  for (std::size_t i = 0, y = 0; y < std::size_t(image.height); ++y)
    for (std::size_t x = 0; x < std::size_t(image.width); ++x, i += 4) {
      auto lit = [&](std::size_t channel) { return (std::uint32_t(rgba[i + channel]) * rgba[i + 3] + 127u) / 255u; };
      reinterpret_cast<std::uint32_t*>(rows + y * stride)[x] =
          std::uint32_t(rgba[i + 3]) << 24 | lit(0) << 16 | lit(1) << 8 | lit(2);
    }
  cairo_surface_mark_dirty(surface.get());
  cairo_save(cairo);
  cairo_rectangle(cairo, plate.low.x, plate.low.y, plate.size.x, plate.size.y);
  cairo_translate(cairo, plate.low.x, plate.low.y);
  cairo_scale(cairo, plate.size.x / image.width, plate.size.y / image.height);
  cairo_set_source_surface(cairo, surface.get(), 0.0, 0.0);
  cairo_pattern_set_extend(cairo_get_source(cairo), CAIRO_EXTEND_PAD);
  cairo_fill(cairo);
  cairo_restore(cairo);
}

void expectDrawn(cairo_t* cairo) {
  cairo_status_t status = cairo_status(cairo);
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(ExitCode::Input, std::string("the drawing cannot be drawn: ") + cairo_status_to_string(status));
}

}  // namespace velum::vector
