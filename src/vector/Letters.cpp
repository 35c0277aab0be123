#include "vector/Letters.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/Text.h"
#include "vector/Typeface.h"

namespace velum::vector {
namespace {

/// Where the letter behind a place of a text begins.
std::size_t nextLetter(std::string_view text, std::size_t at) {
  do ++at;
  while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xc0u) == 0x80u);
  return at;
}

}  // namespace

Letters::Letters(Font font, double em) : mFace(std::make_unique<Typeface>(font)), mFont(font), mEm(em) {}

Letters::~Letters() = default;

double Letters::width(std::string_view text) const { return mFace->width(text) * mEm; }

std::string Letters::fitted(const std::string& text, double most) const {
  if (width(text) <= most) return text;
  auto isStart = [&](std::size_t at) {
    return at == text.size() || (static_cast<unsigned char>(text[at]) & 0xc0u) != 0x80u;
  };
  std::size_t head = text.size() / 2, tail = head;
  for (;;) {
    while (!isStart(head)) --head;
    while (!isStart(tail)) ++tail;
    std::string shorter = text.substr(0, head) + "\u2026" + text.substr(tail);
    if ((head == 0 && tail == text.size()) || width(shorter) <= most) return shorter;
    bool fromHead = head > 0 && head >= text.size() - tail;
    fromHead ? --head : ++tail;
  }
}

/// Words in lines, each as full as it gets.
std::vector<std::string> Letters::filled(const std::vector<std::string>& words, double most) const {
  std::vector<std::string> lines(1);
  double used = 0.0, blank = width(" ");
  for (std::string word : words) {
    bool isFirst = lines.back().empty();
    double longer = used + (isFirst ? 0.0 : blank) + width(word);
    if (longer <= most) {
      lines.back() += (isFirst ? "" : " ") + word;
      used = longer;
      continue;
    }
    if (!isFirst) lines.emplace_back();
    while (width(word) > most) {
      std::size_t end = nextLetter(word, 0);  // a line has one letter, however wide
      for (std::size_t next = end; next < word.size() && width(std::string_view(word).substr(0, next)) <= most;
           next = nextLetter(word, next))
        end = next;
      if (end == word.size()) break;
      lines.back() = word.substr(0, end);
      lines.emplace_back();
      word.erase(0, end);
    }
    used = width(word);
    lines.back() = std::move(word);
  }
  return lines;
}

std::vector<std::string> Letters::lines(std::string_view text, double most) const {
  std::vector<std::string> all;
  for (std::size_t begin = 0; begin <= text.size();) {
    std::size_t end = std::min(text.find('\n', begin), text.size());
    std::vector<std::string> words = wordsOf(text.substr(begin, end - begin)), lines = filled(words, most);
    double low = 0.0, high = most;
    for (const std::string& word : words) low = std::max(low, std::min(width(word), most));
    // The least width that gives as many lines, to a hundredth of the widest.
    while (lines.size() > 1 && high - low > 0.01 * most) {
      double middle = 0.5 * (low + high);
      auto narrower = filled(words, middle);
      if (narrower.size() > lines.size())
        low = middle;
      else
        high = middle, lines = std::move(narrower);
    }
    all.insert(all.end(), lines.begin(), lines.end());
    begin = end + 1;
  }
  return all;
}

Words Letters::words(std::string text, glm::dvec2 start, glm::vec3 color) const {
  return {std::move(text), start, mEm, mFont, color, 1.0, {}};
}

std::vector<Glyph> Letters::glyphs(std::string_view text) const {
  std::vector<Glyph> all = mFace->glyphs(text);
  for (Glyph& glyph : all) glyph.x *= mEm;
  return all;
}

std::vector<Outline> Letters::outlines(std::string_view text, glm::dvec2 start) const {
  std::vector<Outline> all;
  for (const Glyph& glyph : mFace->glyphs(text))
    for (Outline outline : mFace->outlinesOf(glyph.index)) {
      auto place = [&](glm::dvec2& at) { at = start + mEm * (at + glm::dvec2(glyph.x, 0.0)); };
      place(outline.start);
      for (Curve& curve : outline.curves) place(curve.control1), place(curve.control2), place(curve.end);
      all.push_back(std::move(outline));
    }
  return all;
}

}  // namespace velum::vector
