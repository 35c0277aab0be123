#include "session/structure/StructureRow.h"

#include "core/Text.h"
#include "scene/Scene.h"
#include "session/structure/StructureEdit.h"

namespace velum::session {

void renameStructure(scene::Scene& scene, int id, const std::string& name) {
  changeStructures(scene, {id}, [&](scene::Structure& s) { s.name = trimmed(name); });
}

void colorStructures(scene::Scene& scene, const std::vector<int>& ids, glm::vec3 color) {
  changeStructures(scene, ids, [&](scene::Structure& s) {
    s.color = color;
    s.tint = 1.0;
  });
}

}  // namespace velum::session
