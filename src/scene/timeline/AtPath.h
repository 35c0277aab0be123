#pragma once
#include <fmt/format.h>

#include <string>
#include <string_view>

#include "core/Error.h"
#include "core/Text.h"
#include "scene/json/FieldPaths.h"

/// Reaches the field that a path names, with its type.
namespace velum::scene::detail {

/// The items of lists that are there, by their numbers.
struct NumberedItem {
  template <List T>
  void operator()(T& target, std::string_view head, const std::string& path, const FieldInfo&, auto&& go) const {
    auto index = numberIn(head);
    if (!index || !(*index >= 0 && *index < double(target.size())) || *index != double(std::size_t(*index)))
      throw ArgumentError(fmt::format("{} has {} items; '{}' is none of them", path, target.size(), head));
    go(std::size_t(*index));
  }
};

/// Calls use(member, info) with the field at a path, see PathWalk.
inline void atPath(auto& target, std::string_view path, auto&& use) {
  auto atEnd = [&](auto& field, const std::string&, const FieldInfo& info) { use(field, info); };
  PathWalk<NumberedItem, decltype(atEnd)>{{}, atEnd}.along(target, path, "", {});
}

}  // namespace velum::scene::detail
