#include "scene/json/PathKey.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "core/Error.h"

namespace velum::scene::detail {

namespace {

constexpr std::size_t kNamesInMessage = 8;

bool equalsLoosely(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// "#12".
bool isIdOnly(std::string_view name) { return name.starts_with('#') && bareNumber(name.substr(1)); }

std::string callsOf(const std::vector<NamedItem>& items, const std::vector<std::size_t>& which) {
  std::string text;
  for (std::size_t i = 0; i < std::min(which.size(), kNamesInMessage); ++i) {
    const NamedItem& item = items[which[i]];
    text += text.empty() ? "" : ", ";
    text += item.id < 0         ? item.name
            : item.name.empty() ? fmt::format("{}", item.id)
                                : fmt::format("{} ({})", item.name, item.id);
  }
  if (which.size() > kNamesInMessage) text += fmt::format(" and {} more", which.size() - kNamesInMessage);
  return text;
}

template <class Is>
std::vector<std::size_t> where(const std::vector<NamedItem>& items, Is&& is) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < items.size(); ++i)
    if (is(items[i])) found.push_back(i);
  return found;
}

}  // namespace

PathKey takeKey(std::string_view path, const std::string& list) {
  // Names may hold brackets and dots, and a path of its own: the key ends at the bracket that answers the first one
  // where the path ends or goes on behind that, else at the first bracket where it does.
  auto endsAt = [&](std::size_t end) {
    return end + 1 == path.size() || (end + 2 < path.size() && path[end + 1] == '.');
  };
  auto keyTo = [&](std::size_t end) -> PathKey {
    return {path.substr(1, end - 1), end + 1 < path.size() ? path.substr(end + 2) : std::string_view()};
  };
  int depth = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    depth += path[i] == '[' ? 1 : path[i] == ']' ? -1 : 0;
    if (depth > 0) continue;
    if (endsAt(i)) return keyTo(i);
    break;
  }
  for (std::size_t end = path.find(']'); end != path.npos; end = path.find(']', end + 1))
    if (endsAt(end)) return keyTo(end);
  throw ArgumentError(fmt::format("{}{}: expected {}[NAME] or {}[NAME].FIELD", list, path, list, list));
}

std::optional<std::size_t> bareNumber(std::string_view name) {
  constexpr std::size_t kLarge = 1'000'000'000'000;
  std::size_t number = 0;
  for (char c : name) {
    if (c < '0' || c > '9') return std::nullopt;
    number = std::min(kLarge, number * 10 + std::size_t(c - '0'));
  }
  return name.empty() ? std::nullopt : std::optional(number);
}

void failNoPlace(std::string_view name, std::size_t size, const std::string& list) {
  throw ArgumentError(fmt::format("{} has {} item{}; [{}] is none of them: places begin with 0, an id is [#{}]", list,
                                  size, size == 1 ? "" : "s", name, name));
}

void failNotThere(const std::vector<NamedItem>& items, std::string_view name, const std::string& list) {
  auto all = where(items, [](const NamedItem& item) { return item.id >= 0 || !item.name.empty(); });
  throw ArgumentError(fmt::format("{} has nothing that is called '{}'; there {} {}", list, name,
                                  all.size() == 1 ? "is" : "are", all.empty() ? "none" : callsOf(items, all)));
}

std::size_t findNamed(const std::vector<NamedItem>& items, std::string_view name, const std::string& list) {
  auto withId = [&](std::string_view number) {
    return where(items, [&](const NamedItem& item) { return item.id >= 0 && fmt::format("{}", item.id) == number; });
  };
  bool isId = isIdOnly(name);
  auto found = isId ? withId(name.substr(1))
                    : where(items, [&](const NamedItem& item) { return item.name == name && !name.empty(); });
  if (found.empty() && !isId) found = withId(name);
  if (found.empty() && !isId)
    found = where(items, [&](const NamedItem& item) { return !name.empty() && equalsLoosely(item.name, name); });
  if (found.empty()) failNotThere(items, name, list);
  if (found.size() == 1) return found[0];
  throw ArgumentError(fmt::format("{}: {} items are called '{}': {}; say which by its id or its place", list,
                                  found.size(), name, callsOf(items, found)));
}

}  // namespace velum::scene::detail
