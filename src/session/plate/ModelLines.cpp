#include "session/plate/ModelLines.h"

#include <map>
#include <utility>

#include "core/ImageChannels.h"
#include "scene/Finishes.h"
#include "session/plate/Owners.h"
#include "vector/TraceParts.h"

namespace velum::session {

namespace {

constexpr double kFinishRows = 1000.0;
constexpr double kFinestLine = 0.5;  // pixels

/// What the finish sees of a model.
struct SeenParts {
  SeenParts(const Image& image, const scene::Scene& scene) : size(image.width, image.height) {
    auto type = std::size_t(channelIndex(image, "lines.type")), part = std::size_t(channelIndex(image, "lines.part"));
    auto across = std::size_t(channelIndex(image, "lines.size")),
         depth = std::size_t(channelIndex(image, "lines.depth"));
    std::map<std::pair<int, int>, int> known;
    for (std::size_t i = 0; i < image.pixels.size(); i += image.channels.size()) {
      const float* pixel = &image.pixels[i];
      sizes.push_back(pixel[across]);
      depths.push_back(pixel[depth]);
      int& id = ids.emplace_back(0);
      if (pixel[across] <= 0.0f) continue;
      auto [found, isNew] = known.try_emplace({int(pixel[type]), int(pixel[part])}, int(owners.size()) + 1);
      id = found->second;
      if (isNew) add(scene, int(pixel[type]));
    }
  }
  vector::PartMap map() const { return {size, ids, depths, sizes, groups}; }

  glm::ivec2 size;
  std::vector<int> ids, groups;
  std::vector<float> depths, sizes;
  std::vector<Owner> owners;

 private:
  void add(const scene::Scene& scene, int type) {
    const auto& types = scene.model.data->types;
    bool isOfModel = type >= 0 && std::size_t(type) < types.size();
    owners.push_back(ownerOf(scene, 0, type));
    groups.push_back(isOfModel ? int(types[std::size_t(type)].compartment) + 1 : 0);
  }
};

}  // namespace

std::vector<vector::Item> modelContours(const Image& image, const scene::Scene& scene, Progress& progress) {
  SeenParts seen(image, scene);
  const scene::Finish& finish = scene.finish;
  scene::DepthSteps steps = scene::modelDepthSteps(scene.model);
  double angstrom = scene::modelFrame(scene).length;
  double width = finish.contourWidth * image.height / kFinishRows;
  vector::PartOptions options{finish.contours, finish.contourSteps,    finish.contourStructures,
                              width,           steps.least * angstrom, steps.deep * angstrom};
  vector::Pen pen{finish.contourColor, width, finish.contours, {}};
  return itemsOf(vector::traceParts(seen.map(), options, progress), seen.owners, pen, vector::kWidestPartLine * width,
                 kFinestLine);
}

}  // namespace velum::session
