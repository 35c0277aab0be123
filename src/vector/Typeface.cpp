#include "vector/Typeface.h"

#include <freetype/freetype.h>
#include <freetype/ftoutln.h>

#include "core/Assert.h"
#include "vector/Unicode.h"

namespace velum {
// Made by velum_embed_file().
extern const unsigned char kSansFont[], kSansBoldFont[], kSerifFont[], kSerifBoldFont[];
extern const std::size_t kSansFontSize, kSansBoldFontSize, kSerifFontSize, kSerifBoldFontSize;
}  // namespace velum

namespace velum::vector {
namespace {

/// What FreeType tells of an outline, piece by piece.
struct OutlineTaker {
  std::vector<Outline> outlines;
  double ems;  ///< of a unit of the font

  glm::dvec2 place(const FT_Vector* at) const { return {double(at->x) * ems, -double(at->y) * ems}; }
  glm::dvec2 end() const {
    const Outline& last = outlines.back();
    return last.curves.empty() ? last.start : last.curves.back().end;
  }
  void add(const Curve& curve) { outlines.back().curves.push_back(curve); }
};

int takeStart(const FT_Vector* to, void* taker) {
  auto* self = static_cast<OutlineTaker*>(taker);
  self->outlines.push_back({self->place(to), {}, true});
  return 0;
}
int takeLine(const FT_Vector* to, void* taker) {
  auto* self = static_cast<OutlineTaker*>(taker);
  self->add(straight(self->end(), self->place(to)));
  return 0;
}
int takeParabola(const FT_Vector* control, const FT_Vector* to, void* taker) {
  auto* self = static_cast<OutlineTaker*>(taker);
  glm::dvec2 middle = self->place(control), end = self->place(to);
  self->add({glm::mix(self->end(), middle, 2.0 / 3.0), glm::mix(end, middle, 2.0 / 3.0), end});
  return 0;
}
int takeCurve(const FT_Vector* control1, const FT_Vector* control2, const FT_Vector* to, void* taker) {
  auto* self = static_cast<OutlineTaker*>(taker);
  self->add({self->place(control1), self->place(control2), self->place(to)});
  return 0;
}

}  // namespace

std::span<const unsigned char> fontFile(Font font) {
  switch (font) {
    case Font::Sans:
      return {kSansFont, kSansFontSize};
    case Font::SansBold:
      return {kSansBoldFont, kSansBoldFontSize};
    case Font::Serif:
      return {kSerifFont, kSerifFontSize};
    case Font::SerifBold:
      return {kSerifBoldFont, kSerifBoldFontSize};
  }
  return {};
}

Typeface::Typeface(Font font) {
  std::span<const unsigned char> file = fontFile(font);
  bool isRead = FT_Init_FreeType(&mLibrary) == 0 &&
                FT_New_Memory_Face(mLibrary, file.data(), FT_Long(file.size()), 0, &mFace) == 0;
  VELUM_ASSERT(isRead, "the font is part of the program");
}

Typeface::~Typeface() {
  FT_Done_Face(mFace);
  FT_Done_FreeType(mLibrary);
}

std::uint32_t Typeface::glyphOf(char32_t letter) {
  auto [found, isNew] = mGlyphs.try_emplace(letter, 0u);
  if (isNew) found->second = FT_Get_Char_Index(mFace, letter);
  return found->second;
}

double Typeface::advanceOf(std::uint32_t glyph) {
  auto [found, isNew] = mAdvances.try_emplace(glyph, 0.0);
  if (isNew && FT_Load_Glyph(mFace, glyph, FT_LOAD_NO_SCALE) == 0)
    found->second = double(mFace->glyph->metrics.horiAdvance) / mFace->units_per_EM;
  return found->second;
}

/// How much further apart two letters stand than others. Words stand alone, and digits in columns.
double Typeface::kerningOf(char32_t before, char32_t letter) {
  auto isDigit = [](char32_t of) { return of >= U'0' && of <= U'9'; };
  FT_Vector kerning{};
  if (before <= U' ' || letter <= U' ' || (isDigit(before) && isDigit(letter)) ||
      FT_Get_Kerning(mFace, glyphOf(before), glyphOf(letter), FT_KERNING_UNSCALED, &kerning) != 0)
    return 0.0;
  return double(kerning.x) / mFace->units_per_EM;
}

template <class Use>
double Typeface::walk(std::string_view text, const Use& use) {
  double x = 0.0;
  char32_t before = 0;
  for (char32_t letter : lettersOf(text)) {
    std::uint32_t glyph = glyphOf(letter);
    x += kerningOf(before, letter);
    use(glyph, x);
    x += advanceOf(glyph);
    before = letter;
  }
  return x;
}

double Typeface::width(std::string_view text) {
  return walk(text, [](std::uint32_t, double) {});
}

std::vector<Glyph> Typeface::glyphs(std::string_view text) {
  std::vector<Glyph> all;
  walk(text, [&](std::uint32_t glyph, double x) { all.push_back({glyph, x}); });
  return all;
}

const std::vector<Outline>& Typeface::outlinesOf(std::uint32_t glyph) {
  auto [found, isNew] = mOutlines.try_emplace(glyph);
  if (!isNew || FT_Load_Glyph(mFace, glyph, FT_LOAD_NO_SCALE) != 0) return found->second;
  OutlineTaker taker{{}, 1.0 / mFace->units_per_EM};
  FT_Outline_Funcs take{takeStart, takeLine, takeParabola, takeCurve, 0, 0};
  FT_Outline_Decompose(&mFace->glyph->outline, &take, &taker);
  return found->second = std::move(taker.outlines);
}

const std::shared_ptr<Typeface>& Typefaces::of(Font font) {
  std::shared_ptr<Typeface>& face = mFaces[std::size_t(font)];
  if (!face) face = std::make_shared<Typeface>(font);
  return face;
}

}  // namespace velum::vector
