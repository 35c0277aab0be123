#pragma once
#include <cstdint>
#include <vector>

#include "velum/scene/Scene.h"

namespace velum::render {

/// What becomes of structures in a picture, a set of bits for each label.
struct StructureSets {
  static constexpr std::uint8_t kShown = 1;   ///< it is not hidden
  static constexpr std::uint8_t kSpared = 2;  ///< it is shown, and some cut spares it

  std::vector<std::uint8_t> of;  ///< by label; others are shown
  std::uint8_t bits(std::uint16_t label) const { return label < of.size() ? of[label] : kShown; }
  bool hidesAny() const;
  bool operator==(const StructureSets&) const = default;
};

/// @param isAlone  there is no volume: what has no label shows nothing
StructureSets makeStructureSets(const scene::Scene& scene, bool isAlone);

}  // namespace velum::render
