#include "session/model/TypesAt.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

#include "core/Error.h"
#include "core/NearestName.h"

namespace velum::session {

namespace {

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

/// The type or compartment that a name means; null when there is none.
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
  std::string meant = nearestPath(model, name);
  throw InputError(fmt::format("{}: the model has no type or compartment of this name{}", name,
                               meant.empty() ? "; info lists them" : fmt::format(" (is {} meant?)", meant)));
}

std::string nearestPath(const Model& model, std::string_view name) {
  bool isPath = name.find('.') != std::string_view::npos;
  std::vector<std::string> names, paths;
  for (const Places& places : {typePlaces(model), compartmentPlaces(model)})
    for (const auto& [path, at] : places) {
      names.emplace_back(isPath ? std::string_view(path) : shortName(path));
      paths.push_back(path);
    }
  std::string nearest = nearestName(name, names);
  if (nearest.empty()) return {};
  return paths[std::size_t(std::find(names.begin(), names.end(), nearest) - names.begin())];
}

std::string_view shortName(std::string_view path) { return path.substr(path.rfind('.') + 1); }

}  // namespace velum::session
