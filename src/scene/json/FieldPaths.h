#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/Error.h"
#include "scene/json/FieldJson.h"
#include "scene/json/PathKey.h"

/// Sets single fields of structs by their paths: "rayCast.stepVoxels", "cuts.0.centre", "cuts[Plane 1].enabled",
/// "cuts[0].face".
namespace velum::scene::detail {

/// A value from text: JSON, else a comma list of numbers, else such lists with semicolons between them, else a bare
/// word.
Json parseValue(std::string_view text);

/// The text of a value, which parseValue() reads back, without quotes and brackets where none are needed: mip, 1,2,3.
/// One line.
std::string valueText(const Json& value);

/// The first part of a path, and what follows it: "rayCast" and "mode", "cuts" and "[Plane 1].enabled".
struct PathPart {
  std::string_view head, tail;
};
PathPart takePart(std::string_view path);
/// @throw ArgumentError that names the fields there are @param path  of the struct; empty: the scene
[[noreturn]] void failNoField(std::string_view name, const std::string& path, const std::vector<std::string>& known);

/// @throw ArgumentError where a list can have no item at that index @param most  items of it
void failWhereFull(const std::string& path, std::size_t index, std::size_t most);

/// On the command line a bare value stands for an object with its key field alone, spares=3,4, and a place for a list
/// of one.
template <class T>
Json expanded(Json value) {
  if constexpr (List<T>) {
    constexpr bool isOfVectors = requires { ListTraits<T>::Item::length(); };
    bool isOneVector = isOfVectors && value.is_array() && !value.empty() && value[0].is_number();
    if (!value.is_array() || isOneVector) value = Json::array({value});
    for (auto& item : value) item = expanded<typename ListTraits<T>::Item>(std::move(item));
  } else if constexpr (Keyed<T>) {
    if (!value.is_object()) return {{std::string(T::kKey), std::move(value)}};
  }
  return value;
}

/// Reads a field from text. @param path  of the field, for errors  @throw ArgumentError
template <class T>
void setFromText(T& target, std::string_view text, const std::string& path, const FieldInfo& info) {
  try {
    Json value = parseValue(text);
    if constexpr (std::is_same_v<T, std::string>) {
      if (!value.is_string()) value = std::string(text);
    }
    read(target, expanded<T>(std::move(value)), path, info);
  } catch (const InputError& error) {
    throw ArgumentError(error.what());
  }
}

/// Index of the item that a key names; one whose list knows items by a field (kKey) is appended where it is not there.
template <List T>
std::size_t itemWithKey(T& target, std::string_view name, const std::string& path, std::size_t most) {
  if constexpr (Keyed<typename ListTraits<T>::Item>) {
    std::size_t place = placeWithKey(target, name);
    if (place < target.size() || name.empty()) return findByKey(target, name, path);
    failWhereFull(path, place, most);
    withKey(target.emplace_back(), [&](auto& key, const FieldInfo& info) {
      if constexpr (std::is_same_v<std::remove_cvref_t<decltype(key)>, std::string>)
        key = name;
      else
        setFromText(key, name, fmt::format("{}[{}]", path, name), info);
    });
    return place;
  } else {
    return findInBrackets(target, name, path);
  }
}

/// The one walk along a path to fields that may be changed. Optional parts that are not there, and items of keyed
/// lists, are made on the way.
template <class Items, class Use>
struct PathWalk {
  Items
      items;  ///< items(list, head, path, info, go) calls go(index) for each item that a word such as "3" or "*" names
  Use use;    ///< use(field, path, info), at the end

  template <List T>
  void throughList(T& target, std::string_view rest, const std::string& path, const FieldInfo& info) {
    if (rest.starts_with('[')) {
      PathKey key = takeKey(rest, path);
      std::size_t place = itemWithKey(target, key.name, path, info.most);
      return along(target[place], key.rest, fmt::format("{}[{}]", path, key.name), info);
    }
    std::string_view head = rest.substr(0, rest.find('.'));
    std::string_view tail = head.size() == rest.size() ? "" : rest.substr(head.size() + 1);
    items(target, head, path, info,
          [&](std::size_t index) { along(target[index], tail, fmt::format("{}.{}", path, index), info); });
  }

  template <Fielded T>
  void throughMember(T& target, std::string_view rest, const std::string& path) {
    PathPart part = takePart(rest);
    bool found = false;
    std::vector<std::string> known;
    auto visit = [&](std::string_view name, auto& member, const FieldInfo& info) {
      known.emplace_back(name);
      if (name != part.head) return;
      found = true;
      along(member, part.tail, path.empty() ? std::string(name) : fmt::format("{}.{}", path, name), info);
    };
    T::fields(target, visit);
    if (!found) failNoField(part.head, path, known);
  }

  /// @param rest  the path from `target` on  @param path  what was passed, for errors
  /// @throw ArgumentError naming the part of the path that is not there
  void along(auto& target, std::string_view rest, const std::string& path, const FieldInfo& info) {
    using T = std::remove_cvref_t<decltype(target)>;
    if (rest.empty()) return use(target, path, info);
    if constexpr (Maybe<T>) {
      if (!target) target.emplace();
      along(*target, rest, path, info);
    } else if constexpr (List<T>) {
      throughList(target, rest, path, info);
    } else if constexpr (Fielded<T>) {
      throughMember(target, rest, path);
    } else {
      throw ArgumentError(fmt::format("{} has no part '{}'", path, rest));
    }
  }
};

/// Items as values are set: by number, the one behind the last, too, "+" for that one, "*" for each.
struct SetItems {
  template <List T>
  void operator()(T& target, std::string_view head, const std::string& path, const FieldInfo& info, auto&& go) const {
    if (head == "*") {
      for (std::size_t i = 0; i < target.size(); ++i) go(i);
      return;
    }
    std::size_t index = target.size();
    if (head != "+") {
      index = 0;
      for (char c : head)
        index = c >= '0' && c <= '9' ? std::min(info.most, index * 10 + std::size_t(c - '0')) : info.most;
      if (head.empty() || index > target.size())
        throw ArgumentError(fmt::format("{} has {} items; '{}' is none of them (use + to append, * for each)", path,
                                        target.size(), head));
    }
    failWhereFull(path, index, info.most);
    if (index == target.size()) target.emplace_back();
    go(index);
  }
};

struct SetText {
  std::string_view text;
  void operator()(auto& field, const std::string& path, const FieldInfo& info) const {
    setFromText(field, text, path, info);
  }
};

/// Sets a field of a struct from text. @param rest, path  as of PathWalk::along()  @throw ArgumentError
template <Fielded T>
void assignMember(T& target, std::string_view rest, std::string_view text, const std::string& path) {
  PathWalk<SetItems, SetText>{{}, {text}}.throughMember(target, rest, path);
}

}  // namespace velum::scene::detail
