#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace velum::vector {

/// The letters of a text, made fit to be drawn on one line and written into any file: blanks and line ends of any kind
/// are blanks, other control characters and what is no UTF-8 are the replacement character, one for each byte.
std::vector<char32_t> lettersOf(std::string_view text);

/// A letter in UTF-8.
std::string utf8Of(char32_t letter);

/// The text of these letters: UTF-8 that XML may hold.
std::string cleanText(std::string_view text);

}  // namespace velum::vector
