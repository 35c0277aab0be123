#pragma once
#include <glm/glm.hpp>
#include <glm/gtc/type_precision.hpp>
#include <vector>

namespace velum::render {

/// Gradients of planes z0..z1: differences over two voxels along an axis, of values that are smoothed across it by
/// 1 2 1 both ways, as the shader takes them where there is no texture of them. Differences of single rows would show
/// each slice as a ridge (wood grain on skin and bone); wider filters would take the normals of vessels from their
/// neighbours. Beyond the border a voxel repeats. They are kept relative to the longest of their 27 neighbours, whose
/// length changes slowly, so that directions between two voxels are weighted by the lengths there: else the noise of a
/// flat place would turn the normals of the edge beside it.
/// @param texels  planes z0 - 2 .. z1 + 2 of the level, as far as there are any, the first of them being firstPlane
/// @param longestGradient  what a full length stands for, texels 0..1 of integers, values of floats
/// @return direction in xyz (128 is 0), root of the length in w; Texel is std::uint8_t, std::uint16_t or float
template <class Texel>
std::vector<glm::u8vec4> computeGradients(const Texel* texels, glm::ivec3 dims, int firstPlane, int z0, int z1,
                                          double longestGradient);

/// The differences alone, of planes z0..z1, before they are packed.
/// @param texels  planes z0 - 1 .. z1 + 1, as far as there are any
template <class Texel>
std::vector<glm::vec3> takeDifferences(const Texel* texels, glm::ivec3 dims, int firstPlane, int z0, int z1);

/// Differences as computeGradients() returns them.
/// @param differences  planes z0 - 1 .. z1 + 1, as far as there are any
std::vector<glm::u8vec4> packDifferences(const glm::vec3* differences, glm::ivec3 dims, int z0, int z1,
                                         double longestGradient);

}  // namespace velum::render
