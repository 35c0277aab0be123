#pragma once
#include <cstdint>
#include <vector>

#include "scene/SceneFwd.h"

namespace velum::render {

/// What becomes of structures in a picture: a set of bits for each label.
struct StructureSets {
  static constexpr std::uint8_t kShown = 1;      ///< the structure is not hidden
  static constexpr std::uint8_t kSpared = 2;     ///< it is shown, and spared by cuts of the first class of spareClasses
  static constexpr std::uint8_t kSparedToo = 4;  ///< it is shown, and spared by cuts of the second class
  static constexpr std::uint8_t kSolid = 8;      ///< it is shown as a surface that is opaque
  static constexpr std::uint8_t kVeil = 16;      ///< as a surface that is not opaque; then there is no second class

  std::vector<std::uint8_t> of;    ///< bits by label
  std::uint8_t ofOthers = kShown;  ///< bits of labels that are not in `of`
  /// Classes: sets of enabled cuts, a bit for each cut, that spare the same structures, however deep. A single class
  /// without bits, which holds all that any cut spares, where there would be more than two classes, or there are more
  /// cuts than bits.
  std::vector<std::uint32_t> spareClasses;

  int onlySpared = -1;  ///< the one structure that is spared; -1: none, or several

  std::uint8_t bits(std::uint16_t label) const { return label < of.size() ? of[label] : ofOthers; }
  bool hidesAny() const;
  bool hasAny(std::uint8_t bit) const;
  bool operator==(const StructureSets&) const = default;
};

/// @param isAlone  there is no volume, so that unlabelled places show nothing
StructureSets makeStructureSets(const scene::Scene& scene, bool isAlone);

}  // namespace velum::render
