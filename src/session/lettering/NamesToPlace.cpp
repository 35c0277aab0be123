#include "session/lettering/NamesToPlace.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/Error.h"
#include "scene/Scene.h"
#include "session/lettering/NameGroups.h"
#include "session/lettering/VisibleParts.h"

namespace velum::session {

namespace {

constexpr double kNamedBefore = 1.3;  // by so much a name that is new must be larger than one that is not

using StructurePixels = std::map<std::int32_t, std::uint64_t>;

void checkSeen(const SeenMap& map) {
  std::size_t pixels = std::size_t(std::max(map.size.x, 0)) * std::size_t(std::max(map.size.y, 0));
  for (auto keys : {map.structures, map.types})
    if (!keys.empty() && keys.size() != pixels)
      throw ArgumentError(fmt::format("a map of {} pixels is not {} x {}", keys.size(), map.size.x, map.size.y));
}

bool showsType(const SeenMap& map, std::size_t i) { return !map.types.empty() && map.types[i] >= 0; }

StructurePixels countSeenStructures(const SeenMap& map) {
  StructurePixels counts;
  for (std::size_t i = 0, from = 0; i < map.structures.size(); from = i) {
    // Pixels beside each other mostly show the same.
    std::uint64_t seen = 0;
    for (; i < map.structures.size() && map.structures[i] == map.structures[from]; ++i) seen += !showsType(map, i);
    if (seen > 0 && map.structures[from] > 0) counts[map.structures[from]] += seen;
  }
  return counts;
}

/// A group with what it shows in this picture.
struct SeenGroup {
  SeenName name;
  TypeNumbers types;
  std::vector<std::int32_t> ids;
};

SeenGroup seenGroupOf(const scene::Scene& scene, NameGroup group, const TypePixels& types,
                      const StructurePixels& structures) {
  SeenGroup out{{0, std::move(group.name), 0, {}, 0, {}}, std::move(group.types), {}};
  for (std::uint32_t type : out.types) out.name.pixels += pixelsOf(types, type);
  for (std::size_t i : group.structures) {
    int id = scene.labels.structures[i].id;
    out.ids.push_back(id);
    if (auto found = structures.find(id); found != structures.end()) out.name.pixels += found->second;
  }
  if (!out.ids.empty()) out.name.structure = out.ids[0];
  if (out.ids.empty() && !out.types.empty() && scene.model.data)
    out.name.type = pathOf(*scene.model.data, scene.model.data->types[out.types[0]]);
  // Ids begin at 1, types at 0: types are below 0.
  out.name.key = out.ids.empty() ? -1 - int(out.types.empty() ? 0 : out.types[0]) : out.ids[0];
  return out;
}

/// The names of the scene, that of which most is seen first.
std::vector<SeenGroup> seenGroups(const scene::Scene& scene, const SeenMap& map, std::span<const SeenName> before) {
  TypePixels types = countPixels(map.types, scene.model.data ? scene.model.data->types.size() : 0);
  StructurePixels structures = countSeenStructures(map);
  const std::vector<std::string>& listed = scene.lettering.named;
  std::vector<NameGroup> groups = listed.empty() ? seenTypeGroups(scene, types) : listedGroups(scene, listed, types);
  if (listed.empty()) addShownStructures(groups, scene);
  std::vector<SeenGroup> seen;
  double all = listed.empty() ? double(map.size.x) * map.size.y : 0.0;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    SeenGroup group = seenGroupOf(scene, std::move(groups[i]), types, structures);
    if (!listed.empty()) group.name.key = int(i) + 1;
    if (isMoreThanDot(group.name.pixels, all)) seen.push_back(std::move(group));
  }
  auto weightOf = [&](const SeenGroup& group) {
    bool wasNamed =
        std::any_of(before.begin(), before.end(), [&](const SeenName& other) { return other.name == group.name.name; });
    return double(group.name.pixels) * (wasNamed ? kNamedBefore : 1.0);
  };
  std::stable_sort(seen.begin(), seen.end(),
                   [&](const SeenGroup& a, const SeenGroup& b) { return weightOf(a) > weightOf(b); });
  seen.resize(std::min(seen.size(), std::size_t(std::max(scene.lettering.mostNames, 0))));
  for (SeenGroup& group : seen)
    for (const SeenName& other : before)
      if (other.name == group.name.name) group.name.key = other.key;
  return seen;
}

/// For each pixel the place of its group, or -1. What several groups have is the smallest one's.
std::vector<std::int32_t> groupsOfPixels(const SeenMap& map, const std::vector<SeenGroup>& groups) {
  std::vector<std::size_t> order(groups.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return groups[a].types.size() < groups[b].types.size(); });
  std::map<std::int32_t, std::int32_t> byId, byType;
  for (std::size_t g : order) {
    for (std::int32_t id : groups[g].ids) byId.emplace(id, std::int32_t(g));
    for (std::uint32_t type : groups[g].types) byType.emplace(std::int32_t(type), std::int32_t(g));
  }
  std::vector<std::int32_t> out(std::max(map.structures.size(), map.types.size()), -1);
  std::int32_t lastId = -1, lastType = -1, ofId = -1, ofType = -1;
  auto look = [](const auto& table, std::int32_t key, std::int32_t& last, std::int32_t& of) {
    if (key == last) return of;
    auto found = table.find(key);
    last = key;
    return of = found == table.end() ? -1 : found->second;
  };
  for (std::size_t i = 0; i < out.size(); ++i)
    if (showsType(map, i))
      out[i] = look(byType, map.types[i], lastType, ofType);
    else if (!map.structures.empty())
      out[i] = look(byId, map.structures[i], lastId, ofId);
  return out;
}

}  // namespace

std::vector<SeenName> namesToPlace(const scene::Scene& scene, const SeenMap& map, std::span<const SeenName> before) {
  checkSeen(map);
  std::vector<SeenGroup> groups = seenGroups(scene, map, before);
  if (groups.empty()) return {};
  std::vector<VisiblePart> old;
  for (const SeenName& name : before)
    for (std::size_t g = 0; g < groups.size(); ++g)
      if (groups[g].name.key == name.key) old.push_back({std::int32_t(g), name.pixels, name.anchor, 0.0});
  std::vector<std::int32_t> keys = groupsOfPixels(map, groups);
  std::vector<SeenName> names;
  for (const VisiblePart& part : computeVisibleParts({map.size, keys, map.step}, old)) {
    SeenName name = std::move(groups[std::size_t(part.key)].name);
    name.pixels = part.pixels;
    name.anchor = part.anchor;
    names.push_back(std::move(name));
  }
  return names;
}

}  // namespace velum::session
