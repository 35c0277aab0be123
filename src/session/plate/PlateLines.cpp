#include "session/plate/PlateLines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>

#include "core/ImageChannels.h"
#include "scene/Scene.h"
#include "vector/TraceRegions.h"

namespace velum::session {

namespace {

constexpr double kRowsOfFinish = 1000.0;  // of the picture whose pixels the finish's lengths are in

/// What each pixel belongs to: numbers from 1, and what they stand for.
struct PixelRegions {
  std::vector<int> ids;            ///< row by row; 0: nothing
  std::vector<std::string> names;  ///< by id - 1
};

std::string regionName(const scene::Scene& scene, int structure, int type) {
  if (type >= 0 && scene.model.data && std::size_t(type) < scene.model.data->types.size()) {
    const Model& model = *scene.model.data;
    return scene::shownName(scene.model, pathOf(model, model.types[std::size_t(type)]),
                            model.types[std::size_t(type)].name);
  }
  for (const scene::Structure& listed : scene.labels.structures)
    if (structure > 0 && listed.id == structure) return listed.name;
  return {};
}

PixelRegions regionsOf(const Image& image, const scene::Scene& scene) {
  int depth = channelIndex(image, "Z"), structure = channelIndex(image, "id"),
      instance = channelIndex(image, "instance"), type = channelIndex(image, "type");
  std::size_t channels = image.channels.size(), count = image.pixels.size() / channels;
  PixelRegions regions;
  regions.ids.resize(count);
  std::map<std::tuple<int, int>, int> known;
  for (std::size_t i = 0; i < count; ++i) {
    auto at = [&](int channel, float none) {
      return channel < 0 ? none : image.pixels[i * channels + std::size_t(channel)];
    };
    if (!std::isfinite(at(depth, 0.0f))) continue;
    auto [found, isNew] =
        known.try_emplace({int(at(structure, 0.0f)), int(at(instance, 0.0f))}, int(regions.names.size()) + 1);
    if (isNew) regions.names.push_back(regionName(scene, int(at(structure, 0.0f)), int(at(type, -1.0f))));
    regions.ids[i] = found->second;
  }
  return regions;
}

}  // namespace

render::Layers plateLayers(const scene::Scene& scene) {
  render::Layers layers;
  bool hasLines = scene.finish.contours > 0.0 || scene.finish.hatching > 0.0;
  layers.depth = layers.structure = layers.instance = layers.normal = hasLines;
  layers.type = bool(scene.model.data) && hasLines;
  return layers;
}

std::vector<vector::Layer> tracedLines(const Image& image, const scene::Scene& scene, Progress& progress) {
  std::vector<vector::Layer> layers;
  if (scene.finish.contours <= 0.0) return layers;
  PixelRegions regions = regionsOf(image, scene);
  vector::RegionMap map = vector::traceRegions({{image.width, image.height}, regions.ids, {}}, {}, progress);
  vector::Pen pen{
      scene.finish.contourColor, scene.finish.contourWidth * image.height / kRowsOfFinish, scene.finish.contours, {}};
  std::map<std::string, vector::Shape> byName;
  for (vector::Region& region : map.regions) {
    const std::string& name = regions.names[std::size_t(region.id) - 1];
    vector::Shape& shape = byName.try_emplace(name, vector::Shape{name, {}, pen, {}}).first->second;
    std::ranges::move(region.outlines, std::back_inserter(shape.outlines));
  }
  vector::Layer contours{"contours", {}};
  for (auto& [name, shape] : byName) contours.items.push_back(std::move(shape));
  layers.push_back(std::move(contours));
  return layers;
}

}  // namespace velum::session
