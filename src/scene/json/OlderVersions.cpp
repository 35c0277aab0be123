#include "scene/json/OlderVersions.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/Error.h"
#include "scene/json/PathKey.h"

namespace velum::scene::detail {

namespace {

using Json = nlohmann::ordered_json;

/// Version 1 listed the structures that a cut leaves whole by their ids.
Json sparesFromIds(Json ids) {
  if (!ids.is_array()) return ids;
  Json spares = Json::array();
  for (auto& id : ids) spares.push_back({{"structure", std::move(id)}});
  return spares;
}

/// Version 2 had a share of a structure's instances, which was all or, at 0, nothing.
Json spareWithoutShare(Json spare) {
  if (!spare.is_object() || !spare.contains("share")) return spare;
  if (spare["share"] == 0) spare["distance"] = 0;
  spare.erase("share");
  return spare;
}

Json renamed(Json value, std::string_view old, const char* now) { return value == old ? Json(now) : value; }
Json faceOfSections(Json face) { return renamed(std::move(face), "slice", "section"); }
Json inlayOfSlice(Json use) { return renamed(std::move(use), "slice", "inlay"); }
Json layoutOfSections(Json layout) {
  return renamed(renamed(std::move(layout), "slice", "section"), "volume-and-slice", "volume-and-section");
}

/// A field that has another name, or another form, since a version.
struct Change {
  int since;              ///< files of an older version have it as it was
  std::string_view path;  ///< where it was, under the new names of what it is in; "*": each item of a list
  std::string_view
      name;  ///< what it is called now, in the same object or, by a dot, in one that stands there; "": as before
  Json (*convert)(Json);  ///< its value as it is now; null: as it was
};

constexpr Change kChanges[] = {
    {2, "cuts.*.exempt", "spares", sparesFromIds},
    {2, "cuts.*.centreMm", "centre", nullptr},
    {2, "cuts.*.sizeMm", "size", nullptr},
    {2, "cuts.*.face", "face", faceOfSections},
    {2, "cuts.*.membrane.use", "use", inlayOfSlice},
    {2, "cuts.*.membrane.sliceOpacity", "inlayOpacity", nullptr},
    {2, "cuts.*.membrane.falloffMm", "falloff", nullptr},
    {2, "cuts.*.membrane.field.kernels.*.centreMm", "centre", nullptr},
    {2, "cuts.*.membrane.field.kernels.*.radiusMm", "radius", nullptr},
    {2, "cuts.*.membrane.field.strokes.*.pathMm", "path", nullptr},
    {2, "cuts.*.membrane.field.strokes.*.radiusMm", "radius", nullptr},
    {2, "cuts.*.membrane.pins.*.placeMm", "place", nullptr},
    {2, "cuts.*.membrane.shape.centreMm", "centre", nullptr},
    {2, "camera.eyeMm", "eye", nullptr},
    {2, "camera.targetMm", "target", nullptr},
    {2, "camera.heightMm", "height", nullptr},
    {2, "volume.frame", "timeStep", nullptr},
    {2, "volume.source.spacingMm", "spacing", nullptr},
    {2, "labels.source.spacingMm", "spacing", nullptr},
    {2, "surfaces.*.source.spacingMm", "spacing", nullptr},
    {2, "volume.transfer.unitDistanceMm", "unitDistance", nullptr},
    {2, "volume.channels.*.transfer.unitDistanceMm", "unitDistance", nullptr},
    {2, "slices", "sections", nullptr},
    {2, "sections.crosshairMm", "crosshair", nullptr},
    {2, "sections.layout", "layout", layoutOfSections},
    {2, "sections.axial.panMm", "pan", nullptr},
    {2, "sections.axial.heightMm", "height", nullptr},
    {2, "sections.coronal.panMm", "pan", nullptr},
    {2, "sections.coronal.heightMm", "height", nullptr},
    {2, "sections.sagittal.panMm", "pan", nullptr},
    {3, "cuts.*.spares.*", "", spareWithoutShare},
    {3, "cuts.*.typeSpares", "model.spares", nullptr},
    {3, "cuts.*.wholeInstances", "model.wholeInstances", nullptr},
    {3, "cuts.*.leastMass", "model.leastMass", nullptr},
    {3, "cuts.*.mostMass", "model.mostMass", nullptr},
    {3, "cuts.*.leastCopies", "model.leastCopies", nullptr},
    {3, "cuts.*.mostCopies", "model.mostCopies", nullptr},
    {3, "cuts.*.focus", "model.focus", nullptr},
    {2, "sections.sagittal.heightMm", "height", nullptr},
};

/// Puts the new field in the place of the old one, so that fields keep their order.
void change(Json& object, const std::string& old, const Change& by) {
  Json next = Json::object();
  std::size_t dot = by.name.find('.');
  std::string first(by.name.substr(0, dot));
  for (auto& [name, value] : object.items()) {
    if (name != old) {
      next[name] = std::move(value);
      continue;
    }
    Json now = by.convert ? by.convert(std::move(value)) : std::move(value);
    if (dot == by.name.npos)
      next[first] = std::move(now);
    else
      next[first][std::string(by.name.substr(dot + 1))] = std::move(now);
  }
  object = std::move(next);
}

void changeAt(Json& node, std::string_view path, const Change& by) {
  std::size_t dot = path.find('.');
  std::string head(path.substr(0, dot));
  if (head == "*") {
    if (!node.is_array()) return;
    for (auto& item : node) {
      if (dot == path.npos)
        item = by.convert(std::move(item));
      else
        changeAt(item, path.substr(dot + 1), by);
    }
  } else if (node.is_object() && node.contains(head)) {
    if (dot == path.npos)
      change(node, head, by);
    else
      changeAt(node[head], path.substr(dot + 1), by);
  }
}

bool hasItemCalled(const Json& scene, const std::string& list, std::string_view name) {
  Json::json_pointer at(list);
  if (!scene.contains(at) || !scene.at(at).is_array()) return false;
  return std::ranges::any_of(scene.at(at), [&](const Json& item) {
    return item.is_object() && item.contains("name") && item["name"] == name;
  });
}

/// Up to version 3 a number in the brackets of a track's path was an id, where it is a place now.
std::string withIdsMarked(const Json& scene, std::string path) {
  struct {
    std::string_view path;
    const char* at;
  } constexpr kLists[] = {
      {"cuts", "/cuts"}, {"lettering.captions", "/lettering/captions"}, {"lettering.marks", "/lettering/marks"}};
  for (const auto& list : kLists) {
    if (!path.starts_with(std::string(list.path) + "[")) continue;
    PathKey key = takeKey(std::string_view(path).substr(list.path.size()), std::string(list.path));
    if (bareNumber(key.name) && !hasItemCalled(scene, list.at, key.name)) path.insert(list.path.size() + 1, "#");
  }
  return path;
}

void markIdsInTracks(Json& scene) {
  Json::json_pointer tracks("/timeline/tracks");
  if (!scene.contains(tracks) || !scene.at(tracks).is_array()) return;
  for (Json& track : scene.at(tracks)) {
    if (!track.is_object() || !track.contains("path") || !track["path"].is_string()) continue;
    try {
      track["path"] = withIdsMarked(scene, track["path"].get<std::string>());
    } catch (const ArgumentError&) {  // a bracket that is not closed: no field is called so
    }
  }
}

}  // namespace

void bringUpToDate(Json& scene, int version) {
  for (const Change& by : kChanges)
    if (version < by.since) changeAt(scene, by.path, by);
  if (version < 4) markIdsInTracks(scene);
}

}  // namespace velum::scene::detail
