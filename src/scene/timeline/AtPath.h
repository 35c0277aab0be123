#pragma once
#include <fmt/format.h>

#include <string>
#include <string_view>

#include "core/Error.h"
#include "core/Text.h"
#include "scene/json/FieldPaths.h"

/// Reaches the field that a path names, with its type.
namespace velum::scene::detail {

/// Calls use(member, info) with the field at a path. Optional parts that are not there, and items of keyed lists, are
/// made on the way. @param rest  the path from `target` on  @param path  what was passed, for errors
/// @throw ArgumentError naming the part of the path that is not there
struct PathWalk {
  template <List T>
  static void atItem(T& target, std::string_view rest, const std::string& path, const FieldInfo& info, auto&& use) {
    if (rest.starts_with('[')) {
      PathKey key = takeKey(rest, path);
      std::size_t place = itemWithKey(target, key.name, path, info.most);
      return at(target[place], key.rest, fmt::format("{}[{}]", path, key.name), info, use);
    }
    PathPart part = takePart(rest);
    auto index = numberIn(part.head);
    if (!index || !(*index >= 0 && *index < double(target.size())) || *index != double(std::size_t(*index)))
      throw ArgumentError(fmt::format("{} has {} items; '{}' is none of them", path, target.size(), part.head));
    at(target[std::size_t(*index)], part.tail, fmt::format("{}.{}", path, part.head), info, use);
  }

  template <Fielded T>
  static void atMember(T& target, std::string_view rest, const std::string& path, auto&& use) {
    PathPart part = takePart(rest);
    bool found = false;
    std::vector<std::string> known;
    auto visit = [&](std::string_view name, auto& member, const FieldInfo& info) {
      known.emplace_back(name);
      if (name != part.head) return;
      found = true;
      at(member, part.tail, path.empty() ? std::string(name) : fmt::format("{}.{}", path, name), info, use);
    };
    T::fields(target, visit);
    if (!found) failNoField(part.head, path, known);
  }

  static void at(auto& target, std::string_view rest, const std::string& path, const FieldInfo& info, auto&& use) {
    using T = std::remove_cvref_t<decltype(target)>;
    if (rest.empty()) return use(target, info);
    if constexpr (Maybe<T>) {
      if (!target) target.emplace();
      at(*target, rest, path, info, use);
    } else if constexpr (List<T>) {
      atItem(target, rest, path, info, use);
    } else if constexpr (Fielded<T>) {
      atMember(target, rest, path, use);
    } else {
      throw ArgumentError(fmt::format("{} has no part '{}'", path, rest));
    }
  }
};

/// See PathWalk.
inline void atPath(auto& target, std::string_view path, auto&& use) { PathWalk::at(target, path, "", {}, use); }

}  // namespace velum::scene::detail
