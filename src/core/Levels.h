#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/Model.h"

namespace velum {

/// What is drawn of a molecule: an atom, a bead, or what stands for several. Angstrom, the molecule's frame.
struct Ball {
  glm::vec3 centre{0.0f};
  float radius = 0.0f;
  std::uint8_t element = kResidue;  ///< kResidue where it stands for several
  std::uint8_t chain = 0;           ///< modulo 256; of several the most frequent
  bool operator==(const Ball&) const = default;
};

/// A level of detail: balls one after the other, and how far their outline may be off that of the atoms, angstrom.
struct Level {
  std::uint32_t first = 0, count = 0;
  float error = 0.0f;
  float largest = 0.0f;  ///< radius
  bool operator==(const Level&) const = default;
};

/// Levels of detail of all molecules of a model: made of it by model::computeLevels(), never changed.
struct LevelSet {
  std::vector<Ball> balls;
  std::vector<Level> levels;              ///< of a molecule one after the other, finest first
  std::vector<std::uint32_t> firstLevel;  ///< by molecule, one more at the end
  std::span<const Level> of(std::size_t molecule) const {
    return std::span(levels).subspan(firstLevel[molecule], firstLevel[molecule + 1] - firstLevel[molecule]);
  }
  bool operator==(const LevelSet&) const = default;
};

}  // namespace velum
