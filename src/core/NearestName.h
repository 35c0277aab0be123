#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace velum {

/// The name that was most likely meant by a text that somebody typed. Names that contain the text (three letters or
/// more, capitals do not matter) come first, the shortest of them; else the nearest name by letters left out, added,
/// changed or swapped, up to a third of the letters. @return empty when none is that near
std::string nearestName(std::string_view typed, const std::vector<std::string>& names);
/// nearestName() as a question for the end of a message, " (is 'bone' meant?)"; empty when no name is near enough.
std::string meantText(std::string_view typed, const std::vector<std::string>& names);

}  // namespace velum
