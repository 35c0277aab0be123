#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace velum {

/// Of several names the one that a mistyped one most likely means: letters left out, added, changed or swapped, up to a
/// third of them. @return empty when none is that near
std::string nearestName(std::string_view typed, const std::vector<std::string>& names);

}  // namespace velum
