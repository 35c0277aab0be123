#pragma once
#include <vector>

#include "scene/Scene.h"
#include "session/model/ModelEdit.h"

namespace velum::session {

/// Cuts in the order in which they take instances away: first what lies in regions goes, then, by cuts that are
/// everywhere, what is left.
struct CutKinds {
  std::vector<int> regions, everywhere;  ///< ids
};
CutKinds cutKinds(const scene::Scene& scene, const std::vector<int>& cuts);
/// The scene for the dials of the cuts with regions: the cuts everywhere leave all of the types.
scene::Scene withAllEverywhere(const scene::Scene& scene, const CutKinds& cuts, const TypeNumbers& types);
/// The scene for the dials of the cuts everywhere: nothing of the types is left in the regions.
scene::Scene withNoneInRegions(const scene::Scene& scene, const CutKinds& cuts, const TypeNumbers& types);

}  // namespace velum::session
