#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/Levels.h"
#include "core/Model.h"

namespace velum::model {

/// A ball that stands for some instances of a model, or parts of these, and the type that it shows. Angstrom, the
/// model's frame.
struct WholeBall {
  glm::vec3 centre{0.0f};
  float radius = 0.0f;
  std::uint32_t type = 0;
};

/// A whole model as one thing that is seen from afar: levels of balls, the finest first.
struct WholeModel {
  std::vector<WholeBall> balls;
  std::vector<Level> levels;
  /// Of each level the balls that are seen by who looks towards an octant: bit 0 of its number towards larger x, 1 y,
  /// 2 z. Copies of the balls, behind those of all levels.
  std::vector<std::array<Level, 8>> sides;
};

/// The levels of a whole model: cells of a grid, a ball each, that hides as much of a picture as what is in its cell.
/// Its type is that of one of these, drawn by lot, each as likely as it is large: so that many cells together have the
/// colours of the model. What lies inside has its balls, too, as cuts open it; what is seen from a side are the first
/// along an axis, as deep as next to nothing is seen behind. O(n log n) in the instances.
WholeModel makeWholeModel(const Model& model, const LevelSet& levels);

}  // namespace velum::model
