#include "scene/Finishes.h"

#include <algorithm>

#include "scene/FinishTable.h"
#include "scene/LitSphereTable.h"

namespace velum::scene {

namespace {

/// @param own  whose own lit spheres and paper it has
Finish finishOf(const FinishRow& row, const Finish& own) {
  Finish finish = row.finish;
  finish.ownPaper = own.ownPaper;
  finish.spheres = own.spheres;
  return finish;
}

}  // namespace

std::span<const NamedFinish> finishes() { return finishTable().names(); }

void applyFinish(Scene& scene, std::string_view name) { scene.finish = finishOf(finishTable().at(name), scene.finish); }

std::string_view finishName(const Finish& finish) {
  for (const FinishRow& row : finishTable().rows())
    if (finishOf(row, finish) == finish) return row.named.name;
  return {};
}

bool addsAnything(const Finish& finish) {
  return finish.contours > 0 || finish.litSphere > 0 || finish.hatching > 0 || finish.paper != Paper::None;
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
