#pragma once
#include <glm/glm.hpp>
#include <vector>

namespace velum::render {

/// What the texels of a buffer hold of a volume. PACKED of the shaders, whose shaders/common/packed.glsl reads them.
enum class Packing {
  None,   ///< There is none: one value a texel of a texture.
  Bytes,  ///< Four of 8 bits.
  Shorts  ///< Four of 16 bits.
};

/// Planes z0..z1 of texels that hold 2 x 2 neighbours: the values at (y, z), (y + 1, z), (y, z + 1), (y + 1, z + 1);
/// beyond the border a voxel repeats.
/// @param texels  planes z0..z1 + 1 of the level, as far as there are any, the first of them being firstPlane
template <class Texel>
std::vector<glm::vec<4, Texel>> packTexels(const Texel* texels, glm::ivec3 dims, int firstPlane, int z0, int z1);

}  // namespace velum::render
