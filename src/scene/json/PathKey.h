#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// Names items of a list by what people call them: "labels.structures[aorta].visible", "labels.structures[12].color",
/// "cuts[Plane 1].enabled". A place in the list changes when another item comes or goes; a name and an id do not.
namespace velum::scene::detail {

/// "[name].rest", taken apart.
struct PathKey {
  std::string_view name, rest;
};
/// @throw ArgumentError when the bracket is not closed or something else follows it
PathKey takeKey(std::string_view path, const std::string& list);

/// The name and id by which an item can be called.
struct NamedItem {
  std::string name;
  int id = -1;  ///< -1: it has none
};
/// Index of the item with a name; else of the item whose id is the number that `name` holds; else of the item whose
/// name differs in case only.
/// @throw ArgumentError when there is none, or when several have the name
std::size_t findNamed(const std::vector<NamedItem>& items, std::string_view name, const std::string& list);

template <class Item>
std::size_t findByKey(const std::vector<Item>& list, std::string_view name, const std::string& path) {
  std::vector<NamedItem> items;
  for ([[maybe_unused]] const auto& item : list) {
    NamedItem& named = items.emplace_back();
    if constexpr (requires { std::string(item.name); }) named.name = item.name;
    if constexpr (requires { int(item.id); }) named.id = item.id;
  }
  return findNamed(items, name, path);
}

}  // namespace velum::scene::detail
