#include "session/lettering/NameGroups.h"

#include <algorithm>
#include <optional>

#include "scene/Scene.h"

namespace velum::session {

namespace {

constexpr double kLeastSeen = 2e-4;  // of the picture; below it is a dot that nobody looks for

/// Adds what a group has to that which is called alike, or adds the group.
void addGroup(std::vector<NameGroup>& groups, NameGroup group, const TypePixels& pixels) {
  for (std::uint32_t type : group.types) group.pixels += pixelsOf(pixels, type);
  auto found =
      std::find_if(groups.begin(), groups.end(), [&](const NameGroup& other) { return other.name == group.name; });
  if (found == groups.end()) return groups.push_back(std::move(group));
  found->pixels += group.pixels;
  found->types.insert(found->types.end(), group.types.begin(), group.types.end());
  found->structures.insert(found->structures.end(), group.structures.begin(), group.structures.end());
}

/// What an entry of a list stands for: a type, a compartment, or a structure by its name.
std::optional<NameGroup> listedGroup(const scene::Scene& scene, const std::string& entry) {
  static const Model kNone;
  const Model& model = scene.model.data ? *scene.model.data : kNone;
  auto nameOf = [&](const std::string& inFile) { return scene::shownName(scene.model, entry, inFile); };
  for (std::uint32_t i = 0; i < model.types.size(); ++i)
    if (pathOf(model, model.types[i]) == entry) return NameGroup{nameOf(model.types[i].name), 0, {i}, {}};
  for (std::uint32_t i = 0; i < model.compartments.size(); ++i)
    if (compartmentPath(model, i) == entry)
      return NameGroup{nameOf(model.compartments[i].name), 0, typesBelow(model, i), {}};
  for (std::size_t i = 0; i < scene.labels.structures.size(); ++i)
    if (scene.labels.structures[i].name == entry) return NameGroup{entry, 0, {}, {i}};
  return std::nullopt;
}

bool showsModel(const scene::Scene& scene) { return scene.model.data && scene.model.visible; }
bool showsLabels(const scene::Scene& scene) { return scene.labels.data && scene.labels.visible; }

}  // namespace

std::uint64_t pixelsOf(const TypePixels& pixels, std::uint32_t type) {
  return type < pixels.byType.size() ? pixels.byType[type] : 0;
}

bool isMoreThanDot(std::uint64_t pixels, double all) { return double(pixels) > kLeastSeen * all; }

std::vector<NameGroup> listedGroups(const scene::Scene& scene, const std::vector<std::string>& entries,
                                    const TypePixels& pixels) {
  std::vector<NameGroup> groups;
  for (const std::string& entry : entries)
    if (auto group = listedGroup(scene, entry))
      if (group->types.empty() ? showsLabels(scene) : showsModel(scene)) addGroup(groups, std::move(*group), pixels);
  return groups;
}

std::vector<NameGroup> seenTypeGroups(const scene::Scene& scene, const TypePixels& pixels) {
  std::vector<NameGroup> groups;
  if (!showsModel(scene)) return groups;
  const Model& model = *scene.model.data;
  for (std::uint32_t i = 0; i < model.types.size(); ++i)
    if (pixelsOf(pixels, i) > 0)
      addGroup(groups, {scene::shownName(scene.model, pathOf(model, model.types[i]), model.types[i].name), 0, {i}, {}},
               pixels);
  std::erase_if(groups, [&](const NameGroup& group) { return !isMoreThanDot(group.pixels, double(pixels.all)); });
  std::stable_sort(groups.begin(), groups.end(),
                   [](const NameGroup& a, const NameGroup& b) { return a.pixels > b.pixels; });
  return groups;
}

void addShownStructures(std::vector<NameGroup>& groups, const scene::Scene& scene) {
  if (!showsLabels(scene)) return;
  for (std::size_t i = 0; i < scene.labels.structures.size(); ++i) {
    const scene::Structure& structure = scene.labels.structures[i];
    if (structure.visible && structure.opacity > 0.0 && !structure.name.empty())
      addGroup(groups, {structure.name, 0, {}, {i}}, {});
  }
}

}  // namespace velum::session
