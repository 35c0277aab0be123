#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "velum/scene/Scene.h"

namespace velum::render {

/// The transfer function as the shaders read it, over the stretch of data values in which it, or the grey window, changes.
struct TransferTable {
  glm::dvec2 domain{0.0, 1.0};        ///< Data values of table positions 0 and 1.
  double gradientMax = 1.0;           ///< Gradient magnitude of position 1 of the third row, value per mm.
  std::vector<glm::vec4> rows;        ///< [3][kTransferSize]: (colour*sigma, sigma) 1/mm; their running sums; gradient factor in a
};

/// @param scene  its volume layer's transfer function, window and iso value
TransferTable makeTransferTable(const scene::Scene& scene);

/// Opacity at a value, 0..1: linear between points, constant beyond them, 0 without any.
double opacityAt(const std::vector<scene::OpacityPoint>& points, double value);
glm::dvec3 colorAt(const std::vector<scene::ColorPoint>& points, double value);

}  // namespace velum::render
