#pragma once
#include <cstdint>
#include <vector>

#include "scene/SceneFwd.h"

namespace velum::render {

/// What becomes of structures in a picture, a set of bits for each label.
struct StructureSets {
  static constexpr std::uint8_t kShown = 1;      ///< it is not hidden
  static constexpr std::uint8_t kSpared = 2;     ///< it is shown, and spared by cuts of the first class,
  static constexpr std::uint8_t kSparedToo = 4;  ///< or of the second
  static constexpr std::uint8_t kSolid = 8;      ///< it is shown as a surface that is opaque,
  static constexpr std::uint8_t kVeil = 16;      ///< or as one that is not: then there is no second class

  std::vector<std::uint8_t> of;    ///< by label
  std::uint8_t ofOthers = kShown;  ///< of labels that nobody says anything about
  /// Sets of enabled cuts, a bit each, that spare the same structures, however deep. One without bits where there are
  /// more than two, or cuts than bits: all that some cut spares is in it.
  std::vector<std::uint32_t> spareClasses;

  int onlySpared = -1;  ///< the one structure that is spared; -1: none, or several

  std::uint8_t bits(std::uint16_t label) const { return label < of.size() ? of[label] : ofOthers; }
  bool hidesAny() const;
  bool hasAny(std::uint8_t bit) const;
  bool operator==(const StructureSets&) const = default;
};

/// @param isAlone  there is no volume: what has no label shows nothing
StructureSets makeStructureSets(const scene::Scene& scene, bool isAlone);

}  // namespace velum::render
