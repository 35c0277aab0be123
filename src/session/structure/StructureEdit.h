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

/// What a person calls a structure: its name, or "structure 12" where it has none.
std::string structureName(const scene::Scene& scene, int id);

/// The name of an undo step: "Hide aorta", "Hide 3 structures".
std::string structureLabel(const scene::Scene& scene, std::string_view verb, const std::vector<int>& ids);

/// Changes the structures that have some ids. @param ids  any order; ids that the scene does not list are left out
template <class Change>
void changeStructures(scene::Scene& scene, std::vector<int> ids, Change&& change) {
  std::sort(ids.begin(), ids.end());
  for (auto& structure : scene.labels.structures)
    if (std::binary_search(ids.begin(), ids.end(), structure.id)) change(structure);
}

/// What was shown before one structure was shown alone. Passing state: neither saved nor undone.
struct SoloMemory {
  int structure = 0;         ///< the structure that is shown alone; 0: none, and the other members mean nothing
  std::vector<int> visible;  ///< ids of the structures that were shown, ascending
  double unlabelled = 1.0;
};

/// The structure that is shown alone: the only visible structure, while voxels without a label are hidden. Nothing when
/// there is no such structure.
std::optional<int> soloStructure(const scene::Scene& scene);

/// Shows a structure alone, or, where it is alone already, what was shown before. When one structure is alone and
/// another is to be, what was shown before the first is kept.
/// @return the memory for the next call
SoloMemory toggleSolo(scene::Scene& scene, SoloMemory memory, int id);

}  // namespace velum::session
