#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "vector/Drawing.h"
#include "vector/Letters.h"

struct FT_FaceRec_;
struct FT_LibraryRec_;

namespace velum::vector {

/// The letters of a font, in ems, y down from the base line. One thread at a time.
class Typeface {
 public:
  explicit Typeface(Font font);
  ~Typeface();
  Typeface(const Typeface&) = delete;
  Typeface& operator=(const Typeface&) = delete;

  FT_FaceRec_* face() const { return mFace; }
  double width(std::string_view text);
  std::vector<Glyph> glyphs(std::string_view text);
  /// The outlines of a glyph that stands at 0; they are filled by the non-zero rule.
  const std::vector<Outline>& outlinesOf(std::uint32_t glyph);

 private:
  /// Where the glyphs of a text stand; calls use(glyph, x) for each. @return where the next one would stand
  template <class Use>
  double walk(std::string_view text, const Use& use);
  std::uint32_t glyphOf(char32_t letter);
  double advanceOf(std::uint32_t glyph);
  double kerningOf(char32_t before, char32_t letter);

  FT_LibraryRec_* mLibrary = nullptr;
  FT_FaceRec_* mFace = nullptr;
  std::unordered_map<char32_t, std::uint32_t> mGlyphs;                ///< of letters that were asked for
  std::unordered_map<std::uint32_t, double> mAdvances;                ///< of glyphs that were asked for
  std::unordered_map<std::uint32_t, std::vector<Outline>> mOutlines;  ///< the same
};

/// The fonts that something is drawn with, each opened when it is first asked for. One thread at a time.
class Typefaces {
 public:
  const std::shared_ptr<Typeface>& of(Font font);

 private:
  std::array<std::shared_ptr<Typeface>, std::size(EnumNames<Font>::kNames)> mFaces;
};

}  // namespace velum::vector
