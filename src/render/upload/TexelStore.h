#pragma once
#include <optional>

#include "render/upload/VolumeUpload.h"

namespace velum::render {

/// x * y * z.
std::size_t product(glm::ivec3 v);
/// Bytes of a texel of values.
std::size_t texelBytes(const TexelPlan& plan);
/// Integers four to a texel, where they are integers.
std::optional<TexelPlan> packedPlan(TexelPlan plan);

/// How values of one channel are kept on the GPU; integers four to a texel where a software driver has room for that.
/// @param texels  how many there will be
TexelPlan storedPlan(const Volume& volume, bool isMixed, const gpu::Limits& limits, double texels);

/// The length, in texels, that no gradient of a volume exceeds. @param plan  of its texels
double longestGradientOf(const Volume& volume, const TexelPlan& plan, bool isColor);

/// Makes the textures of a volume of so many texels. @throw gpu::GpuError
void allocateTexels(GpuVolume& volume, const TexelPlan& plan, glm::ivec3 size, bool withGradients);

/// Writes a box of texels, tightly packed, as the volume's plan has them. @param gradients  or nullptr
void writeTexels(GpuVolume& volume, glm::ivec3 origin, glm::ivec3 size, const void* texels,
                 const glm::u8vec4* gradients);

}  // namespace velum::render
