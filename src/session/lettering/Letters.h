#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "session/lettering/Mark.h"

namespace velum::session {

/// Letters of one size, of a font that is part of the program: no display and no fonts of the machine are needed, and
/// the same text has the same pixels everywhere. Letters are not fitted to pixels, so that text of twice the size is
/// twice as wide. One thread at a time.
class Letters {
 public:
  /// @param em  size of the letters, pixels, > 0
  explicit Letters(double em);
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
  /// Draws a text into a mark. @param start  of the base line, pixels of the picture
  void draw(std::string_view text, glm::dvec2 start, Mark& mark) const;

 private:
  std::vector<std::string> filled(const std::vector<std::string>& words, double most) const;

  struct Font;
  std::unique_ptr<Font> mFont;
  double mEm;
};

}  // namespace velum::session
