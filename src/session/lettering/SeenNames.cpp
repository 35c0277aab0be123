#include "session/lettering/SeenNames.h"

#include <algorithm>
#include <cstdint>
#include <string>

#include "core/ImageChannels.h"
#include "render/Renderer.h"
#include "scene/Scene.h"
#include "session/lettering/NameGroups.h"
#include "session/mark/MarkHands.h"
#include "session/structure/StructureEdit.h"

namespace velum::session {

namespace {

/// What a mark names, as scene::Lettering::named says it; empty: nothing.
std::string entryOf(const scene::Scene& scene, const scene::Mark& mark) {
  return mark.structure > 0 ? structureName(scene, mark.structure) : mark.type;
}

bool isNaming(const scene::Scene& scene, const scene::Mark& mark) {
  bool names = mark.kind == scene::MarkKind::Name || mark.kind == scene::MarkKind::Region;
  return names && isShown(scene, mark) && !entryOf(scene, mark).empty();
}

/// The scene with these names to be found.
scene::Scene naming(scene::Scene scene, std::vector<std::string> entries) {
  scene.lettering.mostNames = int(entries.size());
  scene.lettering.named = std::move(entries);
  return scene;
}

/// Names without those that marks have.
void dropMarked(std::vector<SeenName>& names, const scene::Scene& scene) {
  std::vector<std::string> marked;
  for (const scene::Mark& mark : scene.lettering.marks)
    if (isNaming(scene, mark)) marked.push_back(entryOf(scene, mark));
  if (marked.empty()) return;
  for (const NameGroup& group : listedGroups(scene, marked, {}))
    std::erase_if(names, [&](const SeenName& name) { return name.name == group.name; });
}

}  // namespace

bool needsSeenNames(const scene::Lettering& lettering) {
  return lettering.names || std::ranges::any_of(lettering.marks, [](const scene::Mark& mark) {
           return mark.visible && mark.points.empty();
         });
}

scene::Lettering namingOf(const scene::Lettering& lettering) {
  scene::Lettering out;
  out.names = lettering.names;
  out.named = lettering.named;
  out.mostNames = lettering.mostNames;
  for (const scene::Mark& mark : lettering.marks) {
    bool names = mark.kind == scene::MarkKind::Name || mark.kind == scene::MarkKind::Region;
    if (!mark.visible || !names) continue;
    scene::Mark& kept = out.marks.emplace_back();
    kept.id = mark.id;
    kept.kind = mark.kind;
    if (!mark.points.empty()) kept.points = {glm::dvec3(0.0)};
    kept.structure = mark.structure;
    kept.type = mark.type;
    kept.timeStep = mark.timeStep;
  }
  return out;
}

SeenNames seenNames(const scene::Scene& scene, const SeenMap& map, const SeenNames& before) {
  SeenNames seen;
  if (scene.lettering.names) seen.names = namesToPlace(scene, map, before.names);
  dropMarked(seen.names, scene);
  for (const scene::Mark& mark : scene.lettering.marks)
    if (mark.points.empty() && isNaming(scene, mark))
      for (SeenName& name : namesToPlace(naming(scene, {entryOf(scene, mark)}), map))
        seen.marks.emplace_back(mark.id, std::move(name));
  std::vector<std::int32_t> keys(map.structures.begin(), map.structures.end());
  for (std::size_t i = 0; i < keys.size() && i < map.types.size(); ++i) keys[i] = std::max(keys[i], map.types[i]);
  seen.subject = silhouetteOf({map.size, keys, map.step});
  return seen;
}

ImageMap::ImageMap(const scene::Scene& scene, const Image& image, int step) {
  int id = channelIndex(image, "id"), instance = channelIndex(image, "instance"), type = channelIndex(image, "type"),
      distance = channelIndex(image, "Z");
  if (step == 0) step = mapStep(image.width);
  std::size_t channels = image.channels.size();
  std::int32_t first = std::int32_t(render::firstModelInstance(scene));
  for (int y = 0; y < image.height; y += step)
    for (int x = 0; x < image.width; x += step) {
      const float* pixel = &image.pixels[(std::size_t(y) * std::size_t(image.width) + std::size_t(x)) * channels];
      bool isNothing = instance >= 0 && pixel[instance] < 0.0f;
      mStructures.push_back(isNothing ? -1 : std::int32_t(id < 0 ? 0.0f : pixel[id]));
      if (distance >= 0) mDistances.push_back(pixel[distance]);
      if (type < 0) continue;
      mTypes.push_back(std::int32_t(pixel[type]));
      if (instance >= 0) mInstances.push_back(mTypes.back() < 0 ? -1 : std::int32_t(pixel[instance]) - first);
    }
  mMap = {mapSize({image.width, image.height}, step), mStructures, mTypes, step, mInstances, mDistances};
}

SeenNames seenNames(const scene::Scene& scene, const Image& image, const SeenNames& before) {
  return seenNames(scene, ImageMap(scene, image).map(), before);
}

SeenNames seenNear(const scene::Scene& scene, const Image& image, const SeenNames& near) {
  scene::Scene all = scene;
  all.lettering.mostNames = scene::kMostNames;
  SeenNames seen = seenNames(all, image, near);
  std::erase_if(seen.names, [&](const SeenName& name) {
    return std::ranges::find(near.names, name.key, &SeenName::key) == near.names.end();
  });
  return seen;
}

}  // namespace velum::session
