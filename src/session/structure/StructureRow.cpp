#include "session/structure/StructureRow.h"

#include <algorithm>

#include "core/Text.h"
#include "scene/Scene.h"
#include "session/structure/StructureEdit.h"

namespace velum::session {

void renameStructure(scene::Scene& scene, int id, const std::string& name) {
  const scene::Structure* old = findStructure(scene, id);
  // The legend's list follows, as long as it means this one.
  if (old && !old->name.empty()) {
    auto isCalledSo = [&](const scene::Structure& s) { return s.name == old->name; };
    const auto& all = scene.labels.structures;
    if (std::count_if(all.begin(), all.end(), isCalledSo) == 1)
      std::replace(scene.lettering.entries.begin(), scene.lettering.entries.end(), old->name,
                   std::string(trimmed(name)));
  }
  changeStructures(scene, {id}, [&](scene::Structure& s) { s.name = trimmed(name); });
}

void colorStructures(scene::Scene& scene, const std::vector<int>& ids, glm::vec3 color) {
  changeStructures(scene, ids, [&](scene::Structure& s) {
    s.color = color;
    s.tint = 1.0;
  });
}

}  // namespace velum::session
