#include "vector/CairoPages.h"

#include <cairo-ft.h>
#include <cairo-pdf.h>

#include <array>
#include <memory>

#include "vector/CairoDraw.h"
#include "vector/Typeface.h"
#include "vector/Unicode.h"

namespace velum::vector {
namespace {

cairo_status_t appendTo(void* text, const unsigned char* bytes, unsigned count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

/// The fonts of Cairo. They keep ours, as Cairo keeps theirs for later.
class CairoFonts {
 public:
  CairoFonts() = default;
  ~CairoFonts() {
    for (cairo_font_face_t* font : mFonts)
      if (font) cairo_font_face_destroy(font);
  }
  CairoFonts(const CairoFonts&) = delete;
  CairoFonts& operator=(const CairoFonts&) = delete;

  Typeface& face(Font font) { return *mFaces.of(font); }
  cairo_font_face_t* of(Font font);

 private:
  Typefaces mFaces;
  std::array<cairo_font_face_t*, std::size(EnumNames<Font>::kNames)> mFonts{};
};

cairo_font_face_t* CairoFonts::of(Font font) {
  static const cairo_user_data_key_t kKey{};
  cairo_font_face_t*& made = mFonts[std::size_t(font)];
  if (made) return made;
  const std::shared_ptr<Typeface>& face = mFaces.of(font);
  made = cairo_ft_font_face_create_for_ft_face(face->face(), FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP);
  cairo_font_face_set_user_data(made, &kKey, new std::shared_ptr<Typeface>(face),
                                [](void* kept) { delete static_cast<std::shared_ptr<Typeface>*>(kept); });
  return made;
}

/// Draws a text so that readers know its letters.
void showText(cairo_t* cairo, const Words& words, CairoFonts& fonts) {
  std::string text;
  std::vector<cairo_glyph_t> glyphs;
  std::vector<cairo_text_cluster_t> clusters;
  for (const Glyph& glyph : fonts.face(words.font).glyphs(words.text))
    glyphs.push_back({glyph.index, words.start.x + glyph.x * words.em, words.start.y});
  for (char32_t letter : lettersOf(words.text)) {
    std::string utf8 = utf8Of(letter);
    clusters.push_back({int(utf8.size()), 1});
    text += utf8;
  }
  setColor(cairo, words.color, words.opacity);
  cairo_set_font_face(cairo, fonts.of(words.font));
  cairo_set_font_size(cairo, words.em);
  cairo_show_text_glyphs(cairo, text.data(), int(text.size()), glyphs.data(), int(glyphs.size()), clusters.data(),
                         int(clusters.size()), cairo_text_cluster_flags_t(0));
}

}  // namespace

std::string pagesOf(const std::vector<std::vector<const Item*>>& pages, glm::dvec2 size, double points) {
  std::string pdf;
  std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo_pdf_surface_create_for_stream(appendTo, &pdf, size.x * points, size.y * points), cairo_surface_destroy);
  cairo_pdf_surface_restrict_to_version(surface.get(), CAIRO_PDF_VERSION_1_5);
  std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo(cairo_create(surface.get()), cairo_destroy);
  CairoFonts fonts;
  cairo_scale(cairo.get(), points, points);
  for (const std::vector<const Item*>& page : pages) {
    for (const Item* item : page) {
      if (auto* shape = std::get_if<Shape>(item)) drawShape(cairo.get(), *shape);
      if (auto* words = std::get_if<Words>(item)) {
        drawHalo(cairo.get(), *words, fonts.face(words->font));
        showText(cairo.get(), *words, fonts);
      }
    }
    cairo_show_page(cairo.get());
  }
  cairo_surface_finish(surface.get());
  expectDrawn(cairo.get());
  return pdf;
}

}  // namespace velum::vector
