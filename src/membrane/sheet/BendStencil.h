#pragma once
#include <glm/glm.hpp>
#include <vector>

namespace velum::membrane {

/// Coefficients by which a particle's bending correction follows from its neighbours: kBendClasses^2 stencils of
/// kStencil^2, see shaders/shared/cloth.h. A bending constraint of two adjacent triangles is linear in the places of
/// their four corners ([BERGOU]: K x = 0 when flat), so that the corrections of all constraints on a particle are one
/// weighted sum, whose weights differ only near the border. Both ways to halve a mesh cell into triangles count, so
/// that the sheet has no grain.
/// @param mesh  width and height of a mesh cell
std::vector<float> bendStencils(glm::dvec2 mesh);

}  // namespace velum::membrane
