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
/// @param texels  of the level the planes z0 - 1 - stride.z .. z1 + 1 + stride.z, as far as there are any, the first of
///                them being firstPlane
/// @param longestGradient  what a full length stands for, texels 0..1 of integers, values of floats
/// @param stride  texels of a voxel along each axis: between voxels there is nothing to be seen, so that differences
///                of texels that are closer would be those of the spline between them. They are given a texel
/// @return direction in xyz (128 is 0), root of the length in w; Texel is std::uint8_t, std::uint16_t or float
template <class Texel>
std::vector<glm::u8vec4> computeGradients(const Texel* texels, glm::ivec3 dims, int firstPlane, int z0, int z1,
                                          double longestGradient, glm::ivec3 stride = glm::ivec3(1));

}  // namespace velum::render
