#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace velum {

/// Of several names the one that most likely is meant: first one that holds what was typed, three letters or more, in
/// capitals or not, the shortest of those; else one with letters left out, added, changed or swapped, up to a third of
/// them. @return empty when none is that near
std::string nearestName(std::string_view typed, const std::vector<std::string>& names);
/// It as a question within a message, " (is 'bone' meant?)"; empty when none is that near.
std::string meantText(std::string_view typed, const std::vector<std::string>& names);

}  // namespace velum
