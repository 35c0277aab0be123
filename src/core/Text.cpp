#include "velum/core/Text.h"

#include <algorithm>
#include <charconv>
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

}  // namespace velum
