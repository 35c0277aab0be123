#pragma once
#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/Scene.h"

namespace velum::session {

/// The structure with an id; null when the scene does not list it.
const scene::Structure* findStructure(const scene::Scene& scene, int id);

/// What a person calls it: its name, or "structure 12".
std::string structureName(const scene::Scene& scene, int id);

/// The name of an undo step: "Hide aorta", "Hide 3 structures".
std::string structureLabel(const scene::Scene& scene, std::string_view verb, const std::vector<int>& ids);

/// Changes the structures with some ids. @param ids  any order; unknown ones are left out
template <class Change>
void changeStructures(scene::Scene& scene, std::vector<int> ids, Change&& change) {
  std::sort(ids.begin(), ids.end());
  for (auto& structure : scene.labels.structures)
    if (std::binary_search(ids.begin(), ids.end(), structure.id)) change(structure);
}

/// What was shown before one structure was shown alone. Passing state.
struct SoloMemory {
  int structure = 0;         ///< that is shown alone; 0: none, and the rest means nothing
  std::vector<int> visible;  ///< ids, ascending
  double unlabelled = 1.0;
};

/// The structure that is shown alone: the only visible one, without what has no label. Nothing when there is none.
std::optional<int> soloStructure(const scene::Scene& scene);

/// Shows a structure alone, or, where it is alone already, what was shown before. From one structure that is alone to
/// another, what was shown before both is kept.
/// @return the memory for the next call
SoloMemory toggleSolo(scene::Scene& scene, SoloMemory memory, int id);

}  // namespace velum::session
