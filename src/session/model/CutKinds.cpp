#include "session/model/CutKinds.h"

#include <algorithm>

#include "session/model/TypeDials.h"

namespace velum::session {

namespace {

/// The scene with one share of all of these types in some cuts.
scene::Scene withShares(scene::Scene scene, const std::vector<int>& cuts, const TypeNumbers& types, double share) {
  for (std::uint32_t type : types)
    setDial(scene, cuts, pathOf(*scene.model.data, scene.model.data->types[type]), DialField::Share, share);
  return scene;
}

}  // namespace

CutKinds cutKinds(const scene::Scene& scene, const std::vector<int>& cuts) {
  CutKinds kinds;
  for (const scene::Cut& cut : scene.cuts)
    if (cut.enabled && std::find(cuts.begin(), cuts.end(), cut.id) != cuts.end())
      (cut.shape == scene::CutShape::Everywhere ? kinds.everywhere : kinds.regions).push_back(cut.id);
  return kinds;
}

scene::Scene withAllEverywhere(const scene::Scene& scene, const CutKinds& cuts, const TypeNumbers& types) {
  return withShares(scene, cuts.everywhere, types, 1.0);
}

scene::Scene withNoneInRegions(const scene::Scene& scene, const CutKinds& cuts, const TypeNumbers& types) {
  return withShares(scene, cuts.regions, types, 0.0);
}

}  // namespace velum::session
