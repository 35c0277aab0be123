#pragma once
#include <glm/glm.hpp>
#include <glm/gtc/type_precision.hpp>
#include <vector>

#include "core/Volume.h"

namespace velum::render {

/// Gradients as a texture has them, unset when they are new.
using PackedGradients = std::vector<glm::u8vec4, UnsetAllocator<glm::u8vec4>>;

/// Differences of planes z0..z1 over two voxels along an axis, of values that are smoothed by 1 2 1 along both other
/// axes, as the shader takes differences where there is no texture of gradients. Differences of single rows would show
/// each slice as a ridge. Beyond the border a voxel repeats.
/// @param texels  planes z0 - 1 .. z1 + 1 of the level, as far as there are any, the first of them being firstPlane;
///                Texel is std::uint8_t or float
/// @return three numbers a texel
template <class Texel>
std::vector<float> takeDifferences(const Texel* texels, glm::ivec3 dims, int firstPlane, int z0, int z1);

/// Gradients of planes z0..z1 as a texture has them: relative to the longest gradient among the 27 voxels around each,
/// whose length changes slowly. So directions between two voxels are weighted by the lengths at both; else the noise of
/// a flat place would turn the normals of an edge beside it.
/// @param differences  planes z0 - 1 .. z1 + 1, as far as there are any, three numbers a texel
/// @param longestGradient  the length that a full-length texel stands for
/// @return direction in xyz (128 is 0), root of the length in w
PackedGradients packGradients(const std::vector<float>& differences, glm::ivec3 dims, int z0, int z1,
                              double longestGradient);

}  // namespace velum::render
