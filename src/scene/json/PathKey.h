#pragma once
#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/Fields.h"
#include "scene/SceneFwd.h"

/// Names items of a list by what people call them: "labels.structures[aorta].visible", "labels.structures[12].color",
/// "labels.structures[#12].opacity", "cuts[Plane 1].enabled", "model.types[root.A].visible"; or by their places:
/// "cuts[0].face". A place in the list changes when another item comes or goes; a name and an id do not.
namespace velum::scene::detail {

/// "[name].rest", taken apart.
struct PathKey {
  std::string_view name, rest;
};
/// @throw ArgumentError when the bracket is not closed or something else follows it
PathKey takeKey(std::string_view path, const std::string& list);

/// What an item of a list can be called.
struct NamedItem {
  std::string name;
  int id = -1;  ///< -1: it has none
};
/// Index of the item with the id where the name is "#12", whatever others are called; else of the item with the name;
/// else of the item whose id is the number that `name` holds; else of the item whose name differs in case only.
/// @throw ArgumentError when there is none, or when several have the name
std::size_t findNamed(const std::vector<NamedItem>& items, std::string_view name, const std::string& list);
/// @throw ArgumentError that says which items there are
[[noreturn]] void failNotThere(const std::vector<NamedItem>& items, std::string_view name, const std::string& list);

/// Items that are known by one of their fields, `kKey`: types by their paths, spares by their structures.
template <class Item>
concept Keyed = requires {
  Item::kKey;
};
/// Calls use(member, info) with the field by which an item is known.
template <Keyed Item>
void withKey(Item& item, auto&& use) {
  auto visit = [&](std::string_view name, auto& member, const FieldInfo& info) {
    if (name == Item::kKey) use(member, info);
  };
  std::remove_const_t<Item>::fields(item, visit);
}

template <class Item>
NamedItem namedItem(const Item& item) {
  NamedItem named;
  if constexpr (Keyed<Item>) {
    withKey(item, [&](const auto& key, const FieldInfo&) {
      if constexpr (requires { std::string(key); }) named.name = key;
      if constexpr (requires { int(key); }) named.id = key;
    });
  } else {
    if constexpr (requires { std::string(item.name); }) named.name = item.name;
    if constexpr (requires { int(item.id); }) named.id = item.id;
  }
  return named;
}

/// Index of the first item with a key, to the letter; the list's size where there is none.
template <Keyed Item>
std::size_t placeWithKey(const std::vector<Item>& list, std::string_view key) {
  auto hasKey = [&](const Item& item) {
    NamedItem named = namedItem(item);
    return !key.empty() && (named.id < 0 ? named.name : std::to_string(named.id)) == key;
  };
  return std::size_t(std::find_if(list.begin(), list.end(), hasKey) - list.begin());
}

/// Index of the item that is called so: by its key where it has one, else see findNamed().
/// @throw ArgumentError that says which items there are
template <class Item>
std::size_t findByKey(const std::vector<Item>& list, std::string_view name, const std::string& path) {
  std::vector<NamedItem> items;
  for ([[maybe_unused]] const auto& item : list) items.push_back(namedItem(item));
  if constexpr (Keyed<Item>) {
    std::size_t place = placeWithKey(list, name);
    return place < list.size() ? place : (failNotThere(items, name, path), place);
  } else {
    return findNamed(items, name, path);
  }
}

/// The number of a structure, and of a strength of one, is its label's, which people know. Ids of all else are counted
/// by the program.
template <class Item>
inline constexpr bool kIsKnownByNumber = std::is_same_v<Item, Structure> || std::is_same_v<Item, LabelStrength>;

/// "12" as a place in a list; nothing for a text that is no whole number.
std::optional<std::size_t> bareNumber(std::string_view name);
/// @throw ArgumentError that says how many items there are
[[noreturn]] void failNoPlace(std::string_view name, std::size_t size, const std::string& list);

/// Index of the item that brackets of a field's path name: the item of this name; where none is called so, a bare
/// number is a place from 0, unless the items are known by numbers; else see findByKey().
/// @throw ArgumentError that says which items there are
template <class Item>
std::size_t findInBrackets(const std::vector<Item>& list, std::string_view name, const std::string& path) {
  if constexpr (!Keyed<Item> && !kIsKnownByNumber<Item>) {
    auto isCalledSo = [&](const Item& item) { return namedItem(item).name == name; };
    if (auto place = bareNumber(name); place && std::none_of(list.begin(), list.end(), isCalledSo))
      return *place < list.size() ? *place : (failNoPlace(name, list.size(), path), *place);
  }
  return findByKey(list, name, path);
}

}  // namespace velum::scene::detail
