#include "StructureSets.h"

#include <algorithm>

namespace velum::render {

bool StructureSets::hidesAny() const {
  return std::any_of(of.begin(), of.end(), [](std::uint8_t bits) { return (bits & kShown) == 0; });
}

StructureSets makeStructureSets(const scene::Scene& scene, bool isAlone) {
  StructureSets sets;
  auto at = [&](int label) -> std::uint8_t& {
    if (std::size_t(label) >= sets.of.size()) sets.of.resize(std::size_t(label) + 1, StructureSets::kShown);
    return sets.of[std::size_t(label)];
  };
  at(0) = isAlone || !(scene.labels.unlabelled > 0.0) ? 0 : StructureSets::kShown;
  for (const auto& structure : scene.labels.structures)
    if (!structure.visible || !(structure.opacity > 0.0)) at(structure.id) = 0;
  for (const auto& cut : scene.cuts)
    for (const auto& spare : cut.spares)
      if (cut.enabled && spare.distance > 0.0 && spare.share > 0.0)
        if (std::uint8_t& bits = at(spare.structure); bits != 0) bits |= StructureSets::kSpared;
  return sets;
}

}  // namespace velum::render
