#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "scene/SceneFwd.h"

namespace velum::session {

/// Gives a structure a name; blanks at the name's ends are left out.
void renameStructure(scene::Scene& scene, int id, const std::string& name);
/// Gives structures a colour of their own: a structure that was grown has the colours of its material until then.
void colorStructures(scene::Scene& scene, const std::vector<int>& ids, glm::vec3 color);

}  // namespace velum::session
