#include "session/structure/StructureEdit.h"

#include <fmt/format.h>

#include "scene/Scene.h"

namespace velum::session {

const scene::Structure* findStructure(const scene::Scene& scene, int id) {
  for (const auto& structure : scene.labels.structures)
    if (structure.id == id) return &structure;
  return nullptr;
}

std::string structureName(const scene::Scene& scene, int id) {
  const scene::Structure* structure = findStructure(scene, id);
  return structure && !structure->name.empty() ? structure->name : fmt::format("structure {}", id);
}

std::string structureLabel(const scene::Scene& scene, std::string_view verb, const std::vector<int>& ids) {
  if (ids.size() == 1) return fmt::format("{} {}", verb, structureName(scene, ids[0]));
  return fmt::format("{} {} structures", verb, ids.size());
}

std::optional<int> soloStructure(const scene::Scene& scene) {
  if (scene.labels.unlabelled != 0.0 || !scene.labels.visible) return std::nullopt;
  std::optional<int> alone;
  for (const auto& structure : scene.labels.structures) {
    if (!structure.visible) continue;
    if (alone) return std::nullopt;
    alone = structure.id;
  }
  return alone;
}

SoloMemory toggleSolo(scene::Scene& scene, SoloMemory memory, int id) {
  auto& labels = scene.labels;
  std::optional<int> alone = soloStructure(scene);
  bool isRemembered = alone && memory.structure == *alone;
  if (alone == id) {
    // Alone without a memory, from a file: then all comes back.
    for (auto& structure : labels.structures)
      structure.visible =
          !isRemembered || std::binary_search(memory.visible.begin(), memory.visible.end(), structure.id);
    labels.unlabelled = isRemembered ? memory.unlabelled : 1.0;
    return {};
  }
  if (!isRemembered) {
    memory = {id, {}, labels.unlabelled};
    for (const auto& structure : labels.structures)
      if (structure.visible) memory.visible.push_back(structure.id);
  }
  memory.structure = id;
  for (auto& structure : labels.structures) structure.visible = structure.id == id;
  labels.unlabelled = 0.0;
  labels.visible = true;
  return memory;
}

}  // namespace velum::session
