#include "scene/TypesFromLabels.h"

#include <utility>

#include "scene/Scene.h"

namespace velum::scene {

void typesFromLabels(Scene& scene) {
  if (!scene.model.data || scene.volume.data || scene.labels.data) return;
  const auto& types = scene.model.data->types;
  for (Cut& cut : scene.cuts) {
    if (!cut.membrane) continue;
    ForceField& field = cut.membrane->field;
    for (const auto& one : std::exchange(field.byLabel, {}))
      if (one.id >= 1 && std::size_t(one.id) <= types.size())
        field.byType.push_back({pathOf(*scene.model.data, types[std::size_t(one.id - 1)]), one.strength});
  }
}

}  // namespace velum::scene
