#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/Model.h"

namespace velum {

/// A ball by which a molecule is drawn: an atom, a bead, or a ball that stands for several atoms. Angstrom, the
/// molecule's frame.
struct Ball {
  glm::vec3 centre{0.0f};
  float radius = 0.0f;
  std::uint8_t element = kResidue;  ///< kResidue where the ball stands for several atoms
  std::uint8_t chain = 0;           ///< chain of the atom modulo 256; of several atoms the most frequent chain
  bool operator==(const Ball&) const = default;
};

/// A level of detail: a range of balls in LevelSet::balls, and how far (angstrom) the outline of these balls may be off
/// the outline of the atoms.
struct Level {
  std::uint32_t first = 0, count = 0;
  float error = 0.0f;
  float largest = 0.0f;  ///< radius
  bool operator==(const Level&) const = default;
};

/// Levels of detail of all molecules of a model: made from the model by model::computeLevels(), never changed after.
struct LevelSet {
  std::vector<Ball> balls;
  std::vector<Level> levels;              ///< those of one molecule follow each other, finest first
  std::vector<std::uint32_t> firstLevel;  ///< by molecule: index of its first level; one more entry at the end
  std::span<const Level> of(std::size_t molecule) const {
    return std::span(levels).subspan(firstLevel[molecule], firstLevel[molecule + 1] - firstLevel[molecule]);
  }
  bool operator==(const LevelSet&) const = default;
};

}  // namespace velum
