#pragma once
#include <optional>

#include "render/upload/VolumeUpload.h"

namespace velum::render {

/// x * y * z.
std::size_t product(glm::ivec3 v);
/// Bytes of a texel of values.
std::size_t texelBytes(const TexelPlan& plan);
/// Bytes of an element of values that are packed.
std::size_t packedBytes(Packing packing);
/// Integers four to a texel, where they are integers.
std::optional<TexelPlan> packedPlan(TexelPlan plan);

/// How values of one channel are kept on the GPU; integers four to a texel where a software driver has room for that.
/// @param texels  how many there will be
TexelPlan storedPlan(const Volume& volume, bool isMixed, const gpu::Limits& limits, double texels);

/// The length, in texels, that no gradient of a volume exceeds. @param plan  of its texels
double longestGradientOf(const Volume& volume, const TexelPlan& plan, bool isColor);

/// Makes the textures of a volume of so many texels. @param packedTexels  of the buffer of values that are packed
/// @throw gpu::GpuError
void allocateTexels(GpuVolume& volume, const TexelPlan& plan, glm::ivec3 size, std::size_t packedTexels,
                    bool withGradients);

/// Writes the values of whole planes of a volume as its plan has them, from plane `z` on.
/// @param size  voxels along x and y, and planes
void writePlanes(GpuVolume& volume, int z, glm::ivec3 size, const void* texels);

}  // namespace velum::render
