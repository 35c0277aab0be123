#include "scene/Finishes.h"

#include <algorithm>

#include "scene/FinishTable.h"
#include "scene/LitSphereTable.h"
#include "scene/ModelLooks.h"

namespace velum::scene {

namespace {

constexpr double kStepAngstrom = 20.0;  // more than the folds of most proteins
constexpr double kDeepShare = 0.03;     // of a model's diameter
constexpr double kDeepSteps = 3.0;      // and at least so many of the least steps

/// A row's finish as a scene has it; where nothing is added the look of a model keeps its own.
Finish finishIn(const Scene& scene, const FinishRow& row) {
  if (&row == &finishTable().rows().front()) return lookFinish(scene);
  Finish finish = row.finish;
  finish.ownPaper = scene.finish.ownPaper;
  finish.spheres = scene.finish.spheres;
  return finish;
}

}  // namespace

std::span<const NamedFinish> finishes() { return finishTable().names(); }

void applyFinish(Scene& scene, std::string_view name) { scene.finish = finishIn(scene, finishTable().at(name)); }

std::string_view finishName(const Scene& scene) {
  for (const FinishRow& row : finishTable().rows())
    if (finishIn(scene, row) == scene.finish) return row.named.name;
  return {};
}

bool addsAnything(const Finish& finish) {
  return finish.contours > 0 || finish.litSphere > 0 || finish.hatching > 0 || finish.paper != Paper::None;
}

bool drawsModelAlone(const Scene& scene) {
  bool drawsGrid = (scene.volume.data && scene.volume.visible) || (scene.labels.data && scene.labels.visible);
  return !drawsGrid && scene.model.visible && scene.model.data && !scene.model.data->instances.empty();
}

DepthSteps modelDepthSteps(const ModelLayer& model) {
  ModelBox box = modelBox(model);
  return {kStepAngstrom, std::max(kDeepSteps * kStepAngstrom, kDeepShare * glm::length(box.high - box.low))};
}

const LitSphere* ownLitSphere(const Finish& finish, std::string_view name) {
  for (const LitSphere& sphere : finish.spheres)
    if (sphere.name == name) return &sphere;
  return nullptr;
}

bool isLitSphere(const Finish& finish, std::string_view name) {
  return ownLitSphere(finish, name) || litSphereTable().find(name);
}

std::vector<std::string> unknownLitSpheres(const Scene& scene) {
  std::vector<std::string> unknown;
  auto look = [&](const std::string& name) {
    if (name.empty() || isLitSphere(scene.finish, name)) return;
    if (std::find(unknown.begin(), unknown.end(), name) == unknown.end()) unknown.push_back(name);
  };
  look(scene.finish.sphere);
  for (const Structure& structure : scene.labels.structures) look(structure.litSphere);
  return unknown;
}

}  // namespace velum::scene
