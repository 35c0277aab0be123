#include "scene/Finishes.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/Error.h"
#include "scene/FinishTable.h"
#include "scene/LitSpheres.h"

namespace velum::scene {

namespace {

const FinishRow& findFinish(std::string_view name) {
  std::string known;
  for (const FinishRow& row : finishTable()) {
    if (row.finish.name == name) return row;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", row.finish.name);
  }
  throw ArgumentError(fmt::format("no finish '{}'; there are {}", name, known));
}

/// @param own  whose own lit spheres and paper it has
Finish finishOf(const FinishRow& row, const Finish& own) {
  Finish finish;
  finish.contours = row.contours;
  finish.contourWidth = row.contourWidth;
  finish.contourColor = row.contourColor;
  finish.contourCreases = row.creases;
  finish.litSphere = row.litSphere;
  finish.sphere = row.sphere;
  finish.structureSpheres = row.structureSpheres;
  finish.hatching = row.hatching;
  finish.hatchWidth = row.hatchWidth;
  finish.paper = row.paper;
  finish.paperColor = row.paperColor;
  finish.paperGrain = row.paperGrain;
  finish.ownPaper = own.ownPaper;
  finish.spheres = own.spheres;
  return finish;
}

}  // namespace

std::span<const NamedFinish> finishes() {
  static const std::vector<NamedFinish> names = [] {
    std::vector<NamedFinish> all;
    for (const FinishRow& row : finishTable()) all.push_back(row.finish);
    return all;
  }();
  return names;
}

void applyFinish(Scene& scene, std::string_view name) { scene.finish = finishOf(findFinish(name), scene.finish); }

std::string_view finishName(const Finish& finish) {
  for (const FinishRow& row : finishTable())
    if (finishOf(row, finish) == finish) return row.finish.name;
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
  auto ours = litSpheres();
  return ownLitSphere(finish, name) ||
         std::any_of(ours.begin(), ours.end(), [&](const LitSphereName& sphere) { return sphere.name == name; });
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
