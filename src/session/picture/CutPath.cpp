#include "session/picture/CutPath.h"

#include <algorithm>

#include "session/extrusion/Extrusion.h"

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
  cut.model.spares = {rowForAll(model, isEverywhere ? 1.0 : 1.0 - at, 1.0 - at)};
  cut.model.leastMass = cut.model.leastCopies = 0.0;
  cut.model.mostMass = cut.model.mostCopies = scene::Spare::kEndless;
}

/// From S2 to S3.
void bringBack(scene::Cut& cut, const Model& model, double at) {
  bool isEverywhere = cut.shape == scene::CutShape::Everywhere;
  for (scene::TypeSpare& row : cut.model.spares) {
    row.share = isEverywhere ? 1.0 + (row.share - 1.0) * at : row.share * at;
    row.viewShare *= at;
    row.amount *= at;
    row.aperture = 1.0 + (row.aperture - 1.0) * at;
  }
  if (!isEverywhere) return;
  // Types for which the cut has no row go, too.
  scene::TypeSpare rest = rowForAll(model, 1.0 - at, 0.0);
  bool isKnown = std::any_of(cut.model.spares.begin(), cut.model.spares.end(),
                             [&](const scene::TypeSpare& own) { return own.type == rest.type; });
  if (!isKnown) cut.model.spares.push_back(std::move(rest));
}

/// How far a flat cut has to go back for all of the data to lie on the side that it leaves.
double wayOut(const scene::Cut& cut, const scene::Bounds& bounds, glm::dvec3 out) {
  double farthest = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    glm::dvec3 share(corner & 1, corner >> 1 & 1, corner >> 2);
    farthest = std::max(farthest, glm::dot(glm::mix(bounds.min, bounds.max, share) - cut.centre, out));
  }
  return farthest + (scene::isMembrane(cut) ? 0.5 * cut.size.z : 0.0);
}

/// From where a cut takes nothing to its place and size. @param at  0..1
void comeIn(scene::Cut& cut, const scene::Bounds& bounds, double at) {
  double left = 1.0 - at * at * (3.0 - 2.0 * at);
  double diagonal = glm::length(bounds.max - bounds.min);
  if (isFlat(cut)) {
    glm::dvec3 out = pullDirection(cut, cut.centre);
    cut.centre += left * wayOut(cut, bounds, out) * out;
  } else if (!cut.invert) {
    cut.size *= 1.0 - left;
  } else {
    cut.size += left * 4.0 * (diagonal + glm::distance(cut.centre, 0.5 * (bounds.min + bounds.max)));
  }
}

scene::Scene bodyPathAt(scene::Scene scene, double at) {
  scene::Bounds bounds = scene::computeBounds(scene);
  if (at < 0.5)
    for (scene::Cut& cut : scene.cuts) comeIn(cut, bounds, 2.0 * at);
  return pulledOut(std::move(scene), std::max(0.0, 2.0 * at - 1.0));
}

}  // namespace

scene::Scene cutPathAt(scene::Scene scene, double at) {
  if (at >= 1.0) return scene;
  if (at <= 0.0) {
    scene.cuts.clear();
    return scene;
  }
  if (!scene.model.data || scene.model.data->compartments.empty()) return bodyPathAt(std::move(scene), at);
  for (scene::Cut& cut : scene.cuts)
    if (at < 0.5)
      takeAway(cut, *scene.model.data, 2.0 * at);
    else
      bringBack(cut, *scene.model.data, 2.0 * at - 1.0);
  return scene;
}

}  // namespace velum::session
