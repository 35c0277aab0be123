#include "session/lettering/Legend.h"

#include <algorithm>

#include "core/ImageChannels.h"
#include "scene/Scene.h"
#include "session/lettering/NameGroups.h"

namespace velum::session {

namespace {

constexpr std::size_t kMostEntries = 20, kMostColors = 4;

/// The colours of a group, that of which the picture shows most first; each once.
std::vector<glm::vec3> colorsOf(const NameGroup& group, const scene::Scene& scene, const std::vector<glm::vec3>& colors,
                                const TypePixels& pixels) {
  std::vector<glm::vec3> out;
  for (std::size_t i : group.structures)
    if (out.size() < kMostColors) out.push_back(scene.labels.structures[i].color);
  TypeNumbers types = group.types;
  std::stable_sort(types.begin(), types.end(),
                   [&](auto a, auto b) { return pixelsOf(pixels, a) > pixelsOf(pixels, b); });
  for (std::uint32_t type : types) {
    if (out.size() == kMostColors) break;
    if (!out.empty() && group.pixels > 0 && pixelsOf(pixels, type) == 0) break;
    glm::vec3 color = glm::clamp(colors[type], 0.0f, 1.0f);
    if (std::find(out.begin(), out.end(), color) == out.end()) out.push_back(color);
  }
  return out;
}

}  // namespace

TypePixels countPixels(std::span<const std::int32_t> types, std::size_t count) {
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
  std::vector<NameGroup> groups = listedGroups(scene, scene.lettering.entries, pixels);
  if (scene.lettering.entries.empty()) {
    groups = seenTypeGroups(scene, pixels);
    addShownStructures(groups, scene);
    groups.resize(std::min(groups.size(), kMostEntries));
  }
  std::vector<glm::vec3> colors;
  if (scene.model.data && scene.model.visible) colors = scene::typeColors(scene.model);
  std::vector<LegendEntry> entries;
  for (const NameGroup& group : groups) entries.push_back({group.name, colorsOf(group, scene, colors, pixels)});
  return entries;
}

}  // namespace velum::session
