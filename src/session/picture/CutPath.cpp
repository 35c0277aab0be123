#include "velum/session/picture/CutPath.h"

#include <algorithm>

namespace velum::session {

namespace {

/// The row of the root, which holds for all types that have none of their own.
scene::TypeSpare rowForAll(const Model& model, double share, double viewShare) {
  scene::TypeSpare row;
  row.type = model.compartments.front().name;
  row.share = share;
  row.viewShare = viewShare;
  return row;
}

/// From S1 to S2.
void takeAway(scene::Cut& cut, const Model& model, double at) {
  bool isEverywhere = cut.shape == scene::CutShape::Everywhere;
  cut.typeSpares = {rowForAll(model, isEverywhere ? 1.0 : 1.0 - at, 1.0 - at)};
  cut.leastMass = cut.leastCopies = 0.0;
  cut.mostMass = cut.mostCopies = scene::Spare::kEndless;
}

/// From S2 to S3.
void bringBack(scene::Cut& cut, const Model& model, double at) {
  bool isEverywhere = cut.shape == scene::CutShape::Everywhere;
  for (scene::TypeSpare& row : cut.typeSpares) {
    row.share = isEverywhere ? 1.0 + (row.share - 1.0) * at : row.share * at;
    row.viewShare *= at;
    row.amount *= at;
    row.aperture = 1.0 + (row.aperture - 1.0) * at;
  }
  if (!isEverywhere) return;
  // What it says nothing of goes, too.
  scene::TypeSpare rest = rowForAll(model, 1.0 - at, 0.0);
  bool isKnown = std::any_of(cut.typeSpares.begin(), cut.typeSpares.end(),
                             [&](const scene::TypeSpare& own) { return own.type == rest.type; });
  if (!isKnown) cut.typeSpares.push_back(std::move(rest));
}

}  // namespace

scene::Scene cutPathAt(scene::Scene scene, double at) {
  if (at >= 1.0 || !scene.model.data || scene.model.data->compartments.empty()) return scene;
  if (at <= 0.0) {
    scene.cuts.clear();
    return scene;
  }
  for (scene::Cut& cut : scene.cuts)
    if (at < 0.5)
      takeAway(cut, *scene.model.data, 2.0 * at);
    else
      bringBack(cut, *scene.model.data, 2.0 * at - 1.0);
  return scene;
}

}  // namespace velum::session
