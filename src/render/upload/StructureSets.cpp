#include "render/upload/StructureSets.h"

#include <algorithm>
#include <map>

#include "scene/Scene.h"
#include "scene/Shown.h"

namespace velum::render {

namespace {

constexpr double kOpaque = 0.995;  ///< what is more opaque hides all that is behind it

/// By structure the enabled cuts that spare it, a bit each; empty bits where there are more cuts than bits.
std::map<int, std::uint32_t> sparingCuts(const scene::Scene& scene) {
  std::map<int, std::uint32_t> cuts;
  auto enabled = std::ranges::distance(scene::enabledOf(scene.cuts));
  int place = 0;
  for (const auto& cut : scene::enabledOf(scene.cuts)) {
    for (const auto& spare : cut.spares)
      if (spare.distance > 0.0) cuts[spare.structure] |= enabled <= 32 ? std::uint32_t(1) << place : 0;
    ++place;
  }
  return cuts;
}

}  // namespace

bool StructureSets::hidesAny() const {
  return std::any_of(of.begin(), of.end(), [](std::uint8_t bits) { return (bits & kShown) == 0; });
}

bool StructureSets::hasAny(std::uint8_t bit) const {
  return (ofOthers & bit) != 0 ||
         std::any_of(of.begin(), of.end(), [bit](std::uint8_t bits) { return (bits & bit) != 0; });
}

StructureSets makeStructureSets(const scene::Scene& scene, bool isAlone) {
  StructureSets sets;
  if (isAlone) sets.ofOthers |= StructureSets::kSolid;
  auto at = [&](int label) -> std::uint8_t& {
    if (std::size_t(label) >= sets.of.size()) sets.of.resize(std::size_t(label) + 1, sets.ofOthers);
    return sets.of[std::size_t(label)];
  };
  at(0) = isAlone || !(scene.labels.unlabelled > 0.0) ? 0 : StructureSets::kShown;
  for (const auto& structure : scene.labels.structures)
    if (!structure.visible || !(structure.opacity > 0.0))
      at(structure.id) = 0;
    else if (isAlone || structure.showAs == scene::ShowAs::Solid)
      at(structure.id) = std::uint8_t(StructureSets::kShown |
                                      (structure.opacity < kOpaque ? StructureSets::kVeil : StructureSets::kSolid));
  std::map<int, std::uint32_t> sparing = sparingCuts(scene);
  std::erase_if(sparing, [&](const auto& entry) { return at(entry.first) == 0; });
  if (sparing.size() == 1) sets.onlySpared = sparing.begin()->first;
  for (const auto& [structure, cuts] : sparing)
    if (std::find(sets.spareClasses.begin(), sets.spareClasses.end(), cuts) == sets.spareClasses.end())
      sets.spareClasses.push_back(cuts);
  if (sets.spareClasses.size() > (sets.hasAny(StructureSets::kVeil) ? 1 : 2)) sets.spareClasses = {0};
  for (const auto& [structure, cuts] : sparing) {
    bool isSecond = sets.spareClasses.size() == 2 && cuts == sets.spareClasses[1];
    at(structure) |= isSecond ? StructureSets::kSparedToo : StructureSets::kSpared;
  }
  return sets;
}

}  // namespace velum::render
