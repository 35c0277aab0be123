#include "velum/session/model/TypesAt.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "velum/core/Error.h"

namespace velum::session {

namespace {

/// How many letters must be put in, taken out or changed to make one text of the other.
std::size_t changesBetween(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      std::size_t above = row[j];
      row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
      diagonal = above;
    }
  }
  return row[b.size()];
}

bool endsWithName(std::string_view path, std::string_view name) {
  return path.ends_with(name) && (path.size() == name.size() || path[path.size() - name.size() - 1] == '.');
}

using Places = std::map<std::string, TypesAt, std::less<>>;

Places typePlaces(const Model& model) {
  Places places;
  for (std::uint32_t i = 0; i < model.types.size(); ++i) {
    std::string path = pathOf(model, model.types[i]);
    TypesAt& at = places[path];
    at.path = path;
    at.types.push_back(i);
  }
  return places;
}

Places compartmentPlaces(const Model& model) {
  Places places;
  for (std::uint32_t i = 0; i < model.compartments.size(); ++i) {
    std::string path = compartmentPath(model, i);
    places.try_emplace(path, TypesAt{path, typesBelow(model, i), true});
  }
  return places;
}

/// The one that is meant; null when there is none.
const TypesAt* findIn(const Places& places, std::string_view name) {
  if (auto whole = places.find(name); whole != places.end()) return &whole->second;
  std::vector<const TypesAt*> found;
  for (const auto& [path, at] : places)
    if (endsWithName(path, name)) found.push_back(&at);
  if (found.size() < 2) return found.empty() ? nullptr : found.front();
  throw InputError(
      fmt::format("{}: {} have this name; say which: {}, {}", name, found.size(), found[0]->path, found[1]->path));
}

}  // namespace

TypesAt typesAt(const Model& model, std::string_view name) {
  Places types = typePlaces(model), compartments = compartmentPlaces(model);
  if (name.empty()) throw InputError("name a type or a compartment of the model");
  if (const TypesAt* found = findIn(types, name)) return *found;
  if (const TypesAt* found = findIn(compartments, name)) return *found;
  std::string nearest;
  std::size_t least = ~std::size_t(0);
  bool isPath = name.find('.') != std::string_view::npos;
  for (const Places* places : {&types, &compartments})
    for (const auto& [path, at] : *places) {
      std::size_t changes = changesBetween(name, isPath ? std::string_view(path) : shortName(path));
      if (changes < least) least = changes, nearest = path;
    }
  throw InputError(
      fmt::format("{}: the model has no type or compartment of this name; the nearest is {}", name, nearest));
}

std::string_view shortName(std::string_view path) { return path.substr(path.rfind('.') + 1); }

}  // namespace velum::session
