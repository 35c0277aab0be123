#pragma once
#include <vector>

#include "gpu/Context.h"
#include "render/residency/BrickTexels.h"
#include "render/residency/PageTable.h"
#include "render/upload/VolumeUpload.h"

namespace velum::render {

/// Where the texels of a slot lie.
struct SlotPlace {
  glm::ivec3 corner{0};     ///< Its first texel in the textures.
  std::size_t element = 0;  ///< Its first element in the buffer, where values are packed.
};

/// Makes the textures of a streamed volume, as large as a budget allows: the coarse volume lies in their corner, and
/// slots around it. Values that are packed are an exception: they lie in a buffer, the coarse volume first, then slot
/// after slot, each in one piece, so that what a ray fetches lies together. GL thread.
/// @param coarse  voxels of the coarse volume  @param most  slots, if the budget allows more  @return the slots  @throw
/// gpu::GpuError
std::vector<SlotPlace> makeSlots(GpuVolume& volume, const TexelPlan& plan, glm::ivec3 coarse, std::size_t most,
                                 double budgetBytes, const gpu::Limits& limits);

/// Writes what a slot holds. GL thread.
void writeSlot(GpuVolume& volume, const SlotPlace& place, const BrickTexels& texels);
/// Writes one value into all texels of a slot, with gradients of no length. GL thread.
/// @param texel  as a sampler returns it
void fillSlot(GpuVolume& volume, const SlotPlace& place, const TexelPlan& plan, float texel);

/// The row of a slot that holds voxels of a level from `origin` on. Scale, first and last are the caller's.
void placeRow(SlotRow& row, const GpuVolume& volume, const SlotPlace& place, glm::ivec3 origin);
/// The same of the coarse volume. @param dims  its voxels
void placeCoarseRow(SlotRow& row, const GpuVolume& volume, glm::ivec3 dims);

}  // namespace velum::render
