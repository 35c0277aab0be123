#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "vector/Drawing.h"

namespace velum::vector {

/// The file (TrueType) of a font that is part of the program. Any thread.
std::span<const unsigned char> fontFile(Font font);

/// A letter as a font draws it.
struct Glyph {
  std::uint32_t index;  ///< in the font; 0: it has no such letter, a box stands for it
  double x;             ///< how far from the begin of its line it stands
};

class Typeface;

/// Measures letters of one font and size. Fonts are part of the program: no display and no fonts of the machine are
/// needed. Letters are not fitted to pixels, so that text of twice the size is twice as wide. Opening a font takes a
/// tenth of a millisecond. One thread at a time.
class Letters {
 public:
  /// @param em  size of the letters, pixels, > 0
  Letters(Font font, double em);
  ~Letters();
  Letters(const Letters&) = delete;
  Letters& operator=(const Letters&) = delete;

  double em() const { return mEm; }
  /// How far a text reaches to the right, pixels. @param text  UTF-8, one line
  double width(std::string_view text) const;
  /// The text, in the middle shortened by an ellipsis where it is wider than that. @param most  pixels
  std::string fitted(const std::string& text, double most) const;
  /// The text in lines that are no wider than that and, where it has to be broken, about equally wide. It is broken
  /// between words, and words that are wider between letters. Line ends of the text stay. @param most  pixels
  std::vector<std::string> lines(std::string_view text, double most) const;
  /// The glyphs of a text, one for each of its letters, with their places in pixels.
  std::vector<Glyph> glyphs(std::string_view text) const;
  /// A text as an item of a drawing. @param start  of the base line, pixels  @param color  sRGB
  Words words(std::string text, glm::dvec2 start, glm::vec3 color) const;
  /// The outlines of a text; they are filled by the non-zero rule. @param start  of the base line, pixels
  std::vector<Outline> outlines(std::string_view text, glm::dvec2 start) const;

 private:
  std::vector<std::string> filled(const std::vector<std::string>& words, double most) const;

  std::unique_ptr<Typeface> mFace;
  Font mFont;
  double mEm;
};

}  // namespace velum::vector
