#include "core/Text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>

namespace velum {

namespace {

constexpr std::string_view kBlanks = " \t\r\n\v\f";

/// What std::from_chars says is out of a double's range: too small with a negative exponent or without one, as in
/// 0.00...1.
double outOfRange(std::string_view number) {
  std::size_t exponent = number.find_first_of("eE");
  bool isSmall = exponent == number.npos ? number.find_first_of("123456789") > number.find('.')
                                         : number.substr(exponent + 1).starts_with('-');
  double size = isSmall ? 0.0 : std::numeric_limits<double>::infinity();
  return number.starts_with('-') ? -size : size;
}

/// Bytes of the UTF-8 character that the text begins with; 0 where it begins with none.
/// Overlong forms, surrogates and what is beyond U+10FFFF are none.
std::size_t characterAt(std::string_view text) {
  auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  unsigned first = byte(0), second = byte(1);
  if (first < 0x80) return 1;
  std::size_t count = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4) return 0;
  for (std::size_t i = 1; i < count; ++i)
    if ((byte(i) & 0xc0) != 0x80) return 0;
  bool isWrong = (first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
                 (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f);
  return isWrong ? 0 : count;
}

/// C0, DEL, and C1 as UTF-8: some terminals take those for commands, too.
bool isControl(std::string_view character) {
  auto first = static_cast<unsigned char>(character[0]);
  if (character.size() == 1) return first < 0x20 || first == 0x7f;
  return first == 0xc2 && static_cast<unsigned char>(character[1]) < 0xa0;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  std::size_t first = text.find_first_not_of(kBlanks);
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::vector<std::string> wordsOf(std::string_view text) {
  std::vector<std::string> words;
  for (std::size_t at = 0; (at = text.find_first_not_of(kBlanks, at)) != text.npos;) {
    std::size_t end = std::min(text.find_first_of(kBlanks, at), text.size());
    words.emplace_back(text.substr(at, end - at));
    at = end;
  }
  return words;
}

std::optional<double> takeNumber(std::string_view& text) {
  std::string_view rest = text.substr(std::min(text.find_first_not_of(kBlanks), text.size()));
  if (rest.starts_with('+') && !rest.starts_with("+-")) rest.remove_prefix(1);
  double value = 0;
  auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
  if (error == std::errc::invalid_argument) return std::nullopt;
  auto length = std::size_t(end - rest.data());
  if (error == std::errc::result_out_of_range) value = outOfRange(rest.substr(0, length));
  text = rest.substr(length);
  return value;
}

std::optional<double> numberIn(std::string_view text) {
  auto value = takeNumber(text);
  return value && trimmed(text).empty() ? value : std::nullopt;
}

std::string tidyNumber(double value) {
  double size = std::abs(value);
  if (size < 1e-30) return "0";
  bool isPlain = size >= 1e-4 && size < 1e7;
  int digits = !isPlain ? 4 : size >= 100 ? 0 : size >= 1 ? 2 : 5;
  char text[64];
  auto format = isPlain ? std::chars_format::fixed : std::chars_format::general;
  auto [end, error] = std::to_chars(std::begin(text), std::end(text), value, format, digits);
  std::string number(text, error == std::errc() ? end : text);
  if (!isPlain || number.find('.') == number.npos) return number;
  number.erase(number.find_last_not_of('0') + 1);
  if (number.back() == '.') number.pop_back();
  return number;
}

std::string grouped(std::uint64_t count, std::string_view separator) {
  std::string text = std::to_string(count);
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, separator);
  return text;
}

std::string csvQuoted(std::string_view text) {
  std::string out = "\"";
  for (char c : text) out.append(c == '"' ? 2u : 1u, c);
  return out + "\"";
}

std::string printable(std::string_view text) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    std::size_t count = characterAt(text);
    std::string_view character = text.substr(0, std::max<std::size_t>(count, 1));
    text.remove_prefix(character.size());
    if (count > 0 && !isControl(character))
      out += character;
    else if (character == "\n" || character == "\t")
      out += character == "\n" ? "\\n" : "\\t";
    else
      for (char c : character) {
        auto byte = static_cast<unsigned char>(c);
        out += {'\\', 'x', kDigits[byte >> 4], kDigits[byte & 15]};
      }
  }
  return out;
}

}  // namespace velum
