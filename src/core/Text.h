#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace velum {

/// The text without the blanks and line ends around it.
std::string_view trimmed(std::string_view text);

/// The words of a text: its parts between blanks and line ends.
std::vector<std::string> wordsOf(std::string_view text);

/// The number that a text begins with; blanks and line ends before the number are passed over. The number is removed
/// from the text together with these; where there is no number the text stays as it is. "+1", "1e9", "inf" and "nan"
/// are numbers; one too small for a double is 0, one too large infinite. The decimal point is a point whatever the
/// user's locale, which std::strtod, std::stod and std::sscanf follow.
std::optional<double> takeNumber(std::string_view& text);

/// The number in a text that consists of one number and nothing else; read as by takeNumber().
std::optional<double> numberIn(std::string_view text);

/// A measured number as people read it: about four digits, 19860 rather than 1.986e+04, and 0 for numbers below 1e-30,
/// which are only left of rounding.
std::string tidyNumber(double value);

/// A count in groups of three digits: "12 345". @param separator  what stands between them
std::string grouped(std::uint64_t count, std::string_view separator);

/// A field of CSV in quotes (RFC 4180).
std::string csvQuoted(std::string_view text);

/// The text made safe to print on one line, whatever a file or a path holds, so that no terminal takes any of it for a
/// command: control characters and bytes that are not UTF-8 become \n, \t or \xNN.
std::string printable(std::string_view text);

}  // namespace velum
