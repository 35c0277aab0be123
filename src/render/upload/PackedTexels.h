#pragma once
#include <glm/glm.hpp>
#include <vector>

namespace velum::render {

/// How the values of a volume are packed into the texels of a buffer; the shaders' define PACKED. Read by
/// shaders/common/packed.glsl.
enum class Packing {
  None,   ///< Not packed: a texture with one value a texel.
  Bytes,  ///< Four values of 8 bits in a texel.
  Shorts  ///< Four values of 16 bits in a texel.
};

/// Planes z0..z1 of texels that hold 2 x 2 neighbours: the values at (y, z), (y + 1, z), (y, z + 1), (y + 1, z + 1);
/// beyond the border a voxel repeats.
/// @param texels  planes z0..z1 + 1 of the level, as far as there are any, the first of them being firstPlane
template <class Texel>
std::vector<glm::vec<4, Texel>> packTexels(const Texel* texels, glm::ivec3 dims, int firstPlane, int z0, int z1);

}  // namespace velum::render
