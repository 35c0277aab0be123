#include "core/NearestName.h"

#include <algorithm>

#include "core/FileName.h"

namespace velum {

namespace {

/// How many letters have to be left out, added, changed or swapped with the next to come from one to the other.
std::size_t editsBetween(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      std::size_t changed = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({changed, last[j] + 1, row[j - 1] + 1});
      bool isSwapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (isSwapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = last;
    last = row;
  }
  return last[b.size()];
}

/// The shortest name that holds what was typed; the first of those. @param typed  in lower case
std::string shortestWith(std::string_view typed, const std::vector<std::string>& names) {
  constexpr std::size_t kLeast = 3;  // fewer letters are in names by chance
  const std::string* found = nullptr;
  for (const auto& name : names)
    if (typed.size() >= kLeast && lowerCase(name).find(typed) != std::string::npos &&
        (!found || name.size() < found->size()))
      found = &name;
  return found ? *found : std::string();
}

}  // namespace

std::string nearestName(std::string_view typed, const std::vector<std::string>& names) {
  constexpr std::size_t kLongest = 64;  // no field is as long; a hostile file's may be
  if (typed.empty() || typed.size() > kLongest) return {};
  std::string nearest = shortestWith(lowerCase(typed), names);
  if (!nearest.empty()) return nearest;
  std::size_t fewest = std::max<std::size_t>(1, typed.size() / 3) + 1;
  for (const auto& name : names) {
    std::size_t edits = editsBetween(lowerCase(typed), lowerCase(name));
    if (edits < fewest) fewest = edits, nearest = name;
  }
  return nearest;
}

std::string meantText(std::string_view typed, const std::vector<std::string>& names) {
  std::string nearest = nearestName(typed, names);
  return nearest.empty() ? "" : " (is '" + nearest + "' meant?)";
}

}  // namespace velum
