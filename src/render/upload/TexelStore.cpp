#include "render/upload/TexelStore.h"

#include <algorithm>
#include <cmath>

namespace velum::render {

using gpu::Format;

std::size_t product(glm::ivec3 v) { return std::size_t(v.x) * std::size_t(v.y) * std::size_t(v.z); }

std::size_t texelBytes(const TexelPlan& plan) {
  return gpu::texelBytes(plan.format) * (plan.packing == Packing::None ? 1 : 4);
}

std::size_t packedBytes(Packing packing) { return packing == Packing::Bytes ? 4 : 8; }

/// Integers four to a texel, where they are integers.
std::optional<TexelPlan> packedPlan(TexelPlan plan) {
  if (plan.format == Format::R8) plan.packing = Packing::Bytes;
  if (plan.format == Format::R16) plan.packing = Packing::Shorts;
  if (plan.packing == Packing::None) return std::nullopt;
  return plan;
}

TexelPlan storedPlan(const Volume& volume, bool isMixed, const gpu::Limits& limits, double texels) {
  TexelPlan plan = planFor(volume, isMixed);
  if (!limits.isSoftware || isMixed || volume.isColor) return plan;
  auto packed = packedPlan(plan);
  return packed && texels <= double(limits.textureBuffer) ? *packed : kAsFloats;
}

void allocateTexels(GpuVolume& volume, const TexelPlan& plan, glm::ivec3 size, std::size_t packedTexels,
                    bool withGradients) {
  volume.packing = plan.packing;
  volume.storeSize = size;
  if (plan.packing != Packing::None) {
    volume.packed = gpu::Buffer("volume", packedTexels * texelBytes(plan));
    volume.texture = gpu::Texture::makeOfBuffer(
        "volume", plan.packing == Packing::Bytes ? Format::R32ui : Format::Rg32ui, volume.packed);
  } else {
    volume.texture = gpu::Texture::make3d("volume", plan.format, size);
  }
  if (withGradients) volume.gradient = gpu::Texture::make3d("gradients", Format::Rgba8, size);
}

void writePlanes(GpuVolume& volume, int z, glm::ivec3 size, const void* texels) {
  if (volume.packing == Packing::None) return volume.texture.write({0, 0, z}, size, texels);
  std::size_t plane = product({size.x, size.y, 1}) * packedBytes(volume.packing);
  volume.packed.write(std::size_t(z) * plane, std::size_t(size.z) * plane, texels);
}

double longestGradientOf(const Volume& volume, const TexelPlan& plan, bool isColor) {
  // No difference is longer than the data's whole range along all three axes.
  double range = isColor ? 1.0 : (volume.range.y - volume.range.x) / std::abs(plan.scale * volume.scale);
  return std::sqrt(3.0) * std::max(1e-30, range);
}

}  // namespace velum::render
