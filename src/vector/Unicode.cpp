#include "vector/Unicode.h"

#include <cstddef>

namespace velum::vector {
namespace {

constexpr char32_t kUnreadable = 0xfffd;

/// What is drawn for a letter of a text.
char32_t drawable(char32_t letter) {
  if (letter >= 0x09 && letter <= 0x0d) return U' ';
  bool isControl = letter < 0x20 || (letter >= 0x7f && letter < 0xa0) || letter == 0xfffe || letter == 0xffff;
  return isControl ? kUnreadable : letter;
}

/// How many bytes the letter has that begins with this one; 0: none does.
std::size_t byteCount(unsigned first) {
  return first < 0x80 ? 1 : first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : first < 0xf5 ? 4 : 0;
}

}  // namespace

std::vector<char32_t> lettersOf(std::string_view text) {
  std::vector<char32_t> letters;
  for (std::size_t i = 0; i < text.size();) {
    auto byte = [&](std::size_t at) { return static_cast<unsigned char>(text[at]); };
    std::size_t count = byteCount(byte(i));
    bool isLetter = count > 0 && i + count <= text.size();
    char32_t letter = count > 1 ? byte(i) & (0x7fu >> count) : byte(i);
    for (std::size_t at = i + 1; isLetter && at < i + count; ++at) {
      isLetter = (byte(at) & 0xc0u) == 0x80u;
      letter = letter << 6 | (byte(at) & 0x3fu);
    }
    // Nor is one in more bytes than it needs, half of a pair of UTF-16, or beyond the last.
    isLetter = isLetter && (count < 3 || letter >= (count == 3 ? 0x800u : 0x10000u)) && letter <= 0x10ffff &&
               (letter < 0xd800 || letter > 0xdfff);
    letters.push_back(isLetter ? drawable(letter) : kUnreadable);
    i += isLetter ? count : 1;
  }
  return letters;
}

std::string utf8Of(char32_t letter) {
  if (letter < 0x80) return {char(letter)};
  auto tail = [&](int shift) { return char(0x80u | (letter >> shift & 0x3fu)); };
  if (letter < 0x800) return {char(0xc0u | letter >> 6), tail(0)};
  if (letter < 0x10000) return {char(0xe0u | letter >> 12), tail(6), tail(0)};
  return {char(0xf0u | letter >> 18), tail(12), tail(6), tail(0)};
}

std::string cleanText(std::string_view text) {
  std::string clean;
  for (char32_t letter : lettersOf(text)) clean += utf8Of(letter);
  return clean;
}

}  // namespace velum::vector
