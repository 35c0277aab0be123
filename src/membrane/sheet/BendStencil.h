#pragma once
#include <glm/glm.hpp>
#include <vector>

namespace velum::membrane {

/// Coefficients by which a particle's bending correction follows from its neighbours: kBendClasses^2 stencils of
/// kStencil^2, see shaders/shared/cloth.h. A bending constraint of two adjacent triangles is linear in the four places
/// ([BERGOU]: K x = 0 when flat), so that what all of them ask of a particle is one weighted sum, different only near
/// the border. Both ways to halve a mesh count, so that the sheet has no grain.
/// @param mesh  width and height of a mesh
std::vector<float> bendStencils(glm::dvec2 mesh);

}  // namespace velum::membrane
