#include "session/lettering/Legend.h"

#include <algorithm>

#include "core/ImageChannels.h"
#include "scene/Scene.h"
#include "session/model/ModelEdit.h"

namespace velum::session {

namespace {

constexpr std::size_t kMostEntries = 20, kMostColors = 4;
constexpr double kLeastSeen = 2e-4;  // of the picture; below it is a dot that nobody looks for

/// Types that share an entry: the numbers of each with how many pixels show it.
struct Group {
  std::string name;
  std::uint64_t pixels = 0;
  TypeNumbers types;
};

std::uint64_t pixelsOf(const TypePixels& pixels, std::uint32_t type) {
  return type < pixels.byType.size() ? pixels.byType[type] : 0;
}

/// Adds types to the group that is called alike, or makes that.
void addGroup(std::vector<Group>& groups, const std::string& name, const TypeNumbers& types, const TypePixels& pixels) {
  auto found = std::find_if(groups.begin(), groups.end(), [&](const Group& group) { return group.name == name; });
  if (found == groups.end()) found = groups.insert(groups.end(), {name, 0, {}});
  for (std::uint32_t type : types) {
    found->pixels += pixelsOf(pixels, type);
    found->types.push_back(type);
  }
}

std::vector<Group> listedGroups(const scene::Scene& scene, const TypePixels& pixels) {
  const Model& model = *scene.model.data;
  std::vector<Group> groups;
  for (const std::string& path : scene.lettering.entries) {
    TypeNumbers types;
    std::string inFile;
    for (std::uint32_t i = 0; i < model.types.size(); ++i)
      if (pathOf(model, model.types[i]) == path) types.push_back(i), inFile = model.types[i].name;
    for (std::uint32_t i = 0; types.empty() && i < model.compartments.size(); ++i)
      if (compartmentPath(model, i) == path) types = typesBelow(model, i), inFile = model.compartments[i].name;
    if (!types.empty()) addGroup(groups, scene::shownName(scene.model, path, inFile), types, pixels);
  }
  return groups;
}

std::vector<Group> seenGroups(const scene::Scene& scene, const TypePixels& pixels) {
  const Model& model = *scene.model.data;
  std::vector<Group> groups;
  for (std::uint32_t i = 0; i < model.types.size(); ++i)
    if (pixelsOf(pixels, i) > 0)
      addGroup(groups, scene::shownName(scene.model, pathOf(model, model.types[i]), model.types[i].name), {i}, pixels);
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
  std::vector<glm::vec3> out;
  for (std::uint32_t type : types) {
    if (!out.empty() && group.pixels > 0 && pixelsOf(pixels, type) == 0) break;
    glm::vec3 color = glm::clamp(colors[type], 0.0f, 1.0f);
    if (std::find(out.begin(), out.end(), color) == out.end()) out.push_back(color);
    if (out.size() == kMostColors) break;
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
  const scene::ModelLayer& layer = scene.model;
  if (!layer.data || !layer.visible) return {};
  std::vector<Group> groups = scene.lettering.entries.empty() ? seenGroups(scene, pixels) : listedGroups(scene, pixels);
  std::vector<glm::vec3> colors = scene::typeColors(layer);
  std::vector<LegendEntry> entries;
  for (const Group& group : groups) entries.push_back({group.name, colorsOf(group, colors, pixels)});
  return entries;
}

}  // namespace velum::session
