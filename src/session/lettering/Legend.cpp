#include "session/lettering/Legend.h"

#include <algorithm>
#include <optional>

#include "core/ImageChannels.h"
#include "scene/Scene.h"
#include "session/model/ModelEdit.h"

namespace velum::session {

namespace {

constexpr std::size_t kMostEntries = 20, kMostColors = 4;
constexpr double kLeastSeen = 2e-4;  // of the picture; below it is a dot that nobody looks for

/// What shares an entry: the numbers of types with how many pixels show them, and structures.
struct Group {
  std::string name;
  std::uint64_t pixels = 0;
  TypeNumbers types;
  std::vector<glm::vec3> colors;  ///< of structures, sRGB
};

std::uint64_t pixelsOf(const TypePixels& pixels, std::uint32_t type) {
  return type < pixels.byType.size() ? pixels.byType[type] : 0;
}

/// Adds what a group has to that which is called alike, or adds the group.
void addGroup(std::vector<Group>& groups, Group group, const TypePixels& pixels) {
  for (std::uint32_t type : group.types) group.pixels += pixelsOf(pixels, type);
  auto found = std::find_if(groups.begin(), groups.end(), [&](const Group& other) { return other.name == group.name; });
  if (found == groups.end()) return groups.push_back(std::move(group));
  found->pixels += group.pixels;
  found->types.insert(found->types.end(), group.types.begin(), group.types.end());
  found->colors.insert(found->colors.end(), group.colors.begin(), group.colors.end());
}

/// What an entry of the list stands for: a type, a compartment, or a structure by its name.
std::optional<Group> listedGroup(const scene::Scene& scene, const std::string& entry) {
  static const Model kNone;
  const Model& model = scene.model.data ? *scene.model.data : kNone;
  auto nameOf = [&](const std::string& inFile) { return scene::shownName(scene.model, entry, inFile); };
  for (std::uint32_t i = 0; i < model.types.size(); ++i)
    if (pathOf(model, model.types[i]) == entry) return Group{nameOf(model.types[i].name), 0, {i}, {}};
  for (std::uint32_t i = 0; i < model.compartments.size(); ++i)
    if (compartmentPath(model, i) == entry)
      return Group{nameOf(model.compartments[i].name), 0, typesBelow(model, i), {}};
  for (const scene::Structure& structure : scene.labels.structures)
    if (structure.name == entry) return Group{entry, 0, {}, {structure.color}};
  return std::nullopt;
}

bool showsModel(const scene::Scene& scene) { return scene.model.data && scene.model.visible; }
bool showsLabels(const scene::Scene& scene) { return scene.labels.data && scene.labels.visible; }

std::vector<Group> listedGroups(const scene::Scene& scene, const TypePixels& pixels) {
  std::vector<Group> groups;
  for (const std::string& entry : scene.lettering.entries)
    if (auto group = listedGroup(scene, entry))
      if (group->types.empty() ? showsLabels(scene) : showsModel(scene)) addGroup(groups, std::move(*group), pixels);
  return groups;
}

/// Adds the structures that are shown and have a name, in the order of their list.
void addStructures(std::vector<Group>& groups, const scene::Scene& scene) {
  for (const scene::Structure& structure : scene.labels.structures)
    if (structure.visible && structure.opacity > 0.0 && !structure.name.empty() && groups.size() < kMostEntries)
      groups.push_back({structure.name, 0, {}, {structure.color}});
}

std::vector<Group> seenGroups(const scene::Scene& scene, const TypePixels& pixels) {
  const Model& model = *scene.model.data;
  std::vector<Group> groups;
  for (std::uint32_t i = 0; i < model.types.size(); ++i)
    if (pixelsOf(pixels, i) > 0)
      addGroup(groups, {scene::shownName(scene.model, pathOf(model, model.types[i]), model.types[i].name), 0, {i}, {}},
               pixels);
  std::erase_if(groups, [&](const Group& group) { return double(group.pixels) <= kLeastSeen * double(pixels.all); });
  std::stable_sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) { return a.pixels > b.pixels; });
  if (groups.size() > kMostEntries) groups.resize(kMostEntries);
  return groups;
}

/// The colours of a group, that of which the picture shows most first; each once.
std::vector<glm::vec3> colorsOf(const Group& group, const std::vector<glm::vec3>& colors, const TypePixels& pixels) {
  TypeNumbers types = group.types;
  std::stable_sort(types.begin(), types.end(),
                   [&](auto a, auto b) { return pixelsOf(pixels, a) > pixelsOf(pixels, b); });
  std::vector<glm::vec3> out = group.colors;
  if (out.size() > kMostColors) out.resize(kMostColors);
  for (std::uint32_t type : types) {
    if (out.size() == kMostColors) break;
    if (!out.empty() && group.pixels > 0 && pixelsOf(pixels, type) == 0) break;
    glm::vec3 color = glm::clamp(colors[type], 0.0f, 1.0f);
    if (std::find(out.begin(), out.end(), color) == out.end()) out.push_back(color);
  }
  return out;
}

}  // namespace

TypePixels countPixels(const std::vector<std::int32_t>& types, std::size_t count) {
  TypePixels pixels{std::vector<std::uint64_t>(count), types.size()};
  for (std::int32_t type : types)
    if (type >= 0 && std::size_t(type) < count) ++pixels.byType[std::size_t(type)];
  return pixels;
}

TypePixels countPixels(const Image& image, std::size_t count) {
  int channel = channelIndex(image, "type");
  if (channel < 0) return {};
  std::size_t channels = image.channels.size();
  std::vector<std::int32_t> types;
  types.reserve(image.pixels.size() / channels);
  for (std::size_t i = std::size_t(channel); i < image.pixels.size(); i += channels)
    types.push_back(std::int32_t(image.pixels[i]));
  return countPixels(types, count);
}

std::vector<LegendEntry> legendEntries(const scene::Scene& scene, const TypePixels& pixels) {
  std::vector<Group> groups;
  bool isListed = !scene.lettering.entries.empty();
  if (isListed) groups = listedGroups(scene, pixels);
  if (!isListed && showsModel(scene)) groups = seenGroups(scene, pixels);
  if (!isListed && showsLabels(scene)) addStructures(groups, scene);
  std::vector<glm::vec3> colors = showsModel(scene) ? scene::typeColors(scene.model) : std::vector<glm::vec3>();
  std::vector<LegendEntry> entries;
  for (const Group& group : groups) entries.push_back({group.name, colorsOf(group, colors, pixels)});
  return entries;
}

}  // namespace velum::session
