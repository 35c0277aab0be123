#pragma once
#include <glm/glm.hpp>
#include <glm/gtc/type_precision.hpp>
#include <vector>

#include "render/upload/GradientTexels.h"

namespace velum::render {

/// A box of texels within a block.
struct TexelBox {
  glm::ivec3 origin{0}, size{0};
};

/// Gradients of a block that fits into a processor's cache: what GradientPlanes and packGradients() make of values that
/// are not refined, within rounding, on one thread and in a tenth of the time, as nothing is kept but what the block
/// needs. To the bit the same however a volume is cut into blocks, so long as each has what gradientReach() says around
/// what is wanted of it. Cost: the block's voxels times the widths of the Gaussians. Any thread.
/// @param values   raw values, x fastest; beyond the block they repeat
/// @param spacing  of voxels, any unit
/// @param box      what is wanted of the block; may reach beyond it, where texels repeat
/// @param longestGradient  the length that a full-length texel stands for, raw values
PackedGradients blockGradients(const std::vector<float>& values, glm::ivec3 dims, glm::dvec3 spacing,
                               const TexelBox& box, double longestGradient);

}  // namespace velum::render
