#pragma once
#include <glm/glm.hpp>
#include <glm/gtc/type_precision.hpp>
#include <vector>

namespace velum::render {

/// Central differences of planes z0..z1, as the shader would take them: beyond the border a voxel repeats. They are
/// kept relative to the longest of their 27 neighbours, whose length changes slowly, so that directions between two
/// voxels are weighted by the lengths there: else the noise of a flat place would turn the normals of the edge beside
/// it.
/// @param texels  planes z0 - 2 .. z1 + 2 of the level, as far as there are any, the first of them being firstPlane
/// @param longestGradient  what a full length stands for, texels 0..1 of integers, values of floats
/// @return direction in xyz (128 is 0), root of the length in w; Texel is std::uint8_t, std::uint16_t or float
template <class Texel>
std::vector<glm::u8vec4> computeGradients(const Texel* texels, glm::ivec3 dims, int firstPlane, int z0, int z1,
                                          double longestGradient);

}  // namespace velum::render
