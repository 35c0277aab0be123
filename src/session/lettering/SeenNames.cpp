#include "session/lettering/SeenNames.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>

#include "core/ImageChannels.h"
#include "render/Renderer.h"
#include "scene/Scene.h"
#include "session/lettering/NameGroups.h"
#include "session/mark/MarkHands.h"
#include "session/model/ModelEdit.h"
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

constexpr float kExactUpTo = 16777216.0f;  // larger whole numbers may be others as floats

/// Finds instances of the model by their numbers in a channel.
class InstancesInChannel {
 public:
  explicit InstancesInChannel(const scene::Scene& scene) : mFirst(render::firstModelInstance(scene)) {
    for (const scene::Mark& mark : scene.lettering.marks)
      for (int wanted : mark.pointInstances) {
        if (wanted < 0) continue;
        float asFloat = float(std::uint32_t(wanted) + mFirst);
        if (asFloat < kExactUpTo) continue;
        if (auto place = instancePlace(scene, std::uint32_t(wanted)))
          mWanted[asFloat].push_back({wanted, place->isWhole ? -1 : std::int32_t(place->type)});
      }
  }
  /// @param type  of the model, which the pixel shows
  std::int32_t instanceOf(float value, std::int32_t type) const {
    std::int32_t about = std::int32_t(std::int64_t(value) - std::int64_t(mFirst));
    if (value < kExactUpTo) return about;
    auto found = mWanted.find(value);
    if (found == mWanted.end()) return about;
    for (const WantedInstance& wanted : found->second)
      if (wanted.type < 0 || wanted.type == type) return wanted.instance;
    return -1;  // of another type than those that are wanted: none of them
  }

 private:
  struct WantedInstance {
    std::int32_t instance, type;  ///< type -1: any
  };
  std::uint32_t mFirst;
  std::map<float, std::vector<WantedInstance>> mWanted;  ///< by their numbers as floats; only inexact ones
};

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
  InstancesInChannel instances(scene);
  for (int y = 0; y < image.height; y += step)
    for (int x = 0; x < image.width; x += step) {
      const float* pixel = &image.pixels[(std::size_t(y) * std::size_t(image.width) + std::size_t(x)) * channels];
      bool isNothing = instance >= 0 && pixel[instance] < 0.0f;
      mStructures.push_back(isNothing ? -1 : std::int32_t(id < 0 ? 0.0f : pixel[id]));
      if (distance >= 0) mDistances.push_back(pixel[distance]);
      if (type < 0) continue;
      mTypes.push_back(std::int32_t(pixel[type]));
      if (instance >= 0)
        mInstances.push_back(mTypes.back() < 0 ? -1 : instances.instanceOf(pixel[instance], mTypes.back()));
    }
  mMap = {mapSize({image.width, image.height}, step), mStructures, mTypes, step, mInstances, mDistances};
}

SeenMap ImageMap::mapOfLarger(int pixels) const {
  SeenMap map = mMap;
  map.step *= pixels;
  return map;
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
