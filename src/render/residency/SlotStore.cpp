#include "render/residency/SlotStore.h"

#include <algorithm>
#include <cmath>

#include "render/upload/TexelStore.h"

namespace velum::render {

namespace {

constexpr int kSlotsAlong = 8;  ///< of the textures, along x and y
constexpr std::size_t kSlotTexels = std::size_t(kSlotEdge) * kSlotEdge * kSlotEdge;

int roundUp(int size) { return (size + kSlotEdge - 1) / kSlotEdge * kSlotEdge; }

template <class Texel>
Bytes repeated(Texel texel, std::size_t count) {
  Bytes bytes(count * sizeof(Texel));
  std::fill_n(reinterpret_cast<Texel*>(bytes.data()), count, texel);
  return bytes;
}

}  // namespace

std::vector<SlotPlace> makeSlots(GpuVolume& volume, const TexelPlan& plan, glm::ivec3 coarse, std::size_t most,
                                 double budgetBytes, const gpu::Limits& limits) {
  bool isPacked = plan.packing != Packing::None;
  double texels = budgetBytes / double(texelBytes(plan) + sizeof(glm::u8vec4));
  if (isPacked) texels = std::min(texels, double(limits.textureBuffer));
  glm::ivec3 size;
  int longest = limits.texture3d / kSlotEdge * kSlotEdge;
  for (int axis = 0; axis < 2; ++axis)
    size[axis] = std::min(longest, std::max(roundUp(coarse[axis]), kSlotsAlong * kSlotEdge));
  int deep = int(texels / (double(size.x) * size.y)) / kSlotEdge * kSlotEdge;
  // Enough for all, where the coarse volume's planes had no slot.
  double perPlane = double(size.x / kSlotEdge) * (size.y / kSlotEdge);
  double enough = roundUp(coarse.z) + kSlotEdge * std::ceil(double(most) / perPlane);
  deep = int(std::min(double(deep), enough));
  size.z = std::min(longest, std::max(roundUp(coarse.z) + kSlotEdge, deep));
  std::vector<SlotPlace> slots;
  glm::ivec3 at;
  std::size_t element = product(coarse);
  for (at.z = 0; at.z < size.z; at.z += kSlotEdge)
    for (at.y = 0; at.y < size.y; at.y += kSlotEdge)
      for (at.x = 0; at.x < size.x; at.x += kSlotEdge) {
        if (!glm::any(glm::greaterThanEqual(at, coarse))) continue;
        if (isPacked && element + kSlotTexels > std::size_t(limits.textureBuffer)) continue;
        slots.push_back({at, element});
        element += kSlotTexels;
      }
  allocateTexels(volume, plan, size, element, true);
  return slots;
}

void writeSlot(GpuVolume& volume, const SlotPlace& place, const BrickTexels& texels) {
  volume.gradient.write(place.corner, glm::ivec3(kSlotEdge), texels.gradients.data());
  if (volume.packing == Packing::None)
    volume.texture.write(place.corner, glm::ivec3(kSlotEdge), texels.texels.data());
  else
    volume.packed.write(place.element * packedBytes(volume.packing), texels.texels.size(), texels.texels.data());
}

void fillSlot(GpuVolume& volume, const SlotPlace& place, const TexelPlan& plan, float texel) {
  std::size_t count = kSlotTexels * (plan.packing == Packing::None ? 1 : 4);
  BrickTexels filled;
  filled.gradients.assign(kSlotTexels, glm::u8vec4(128, 128, 128, 0));
  if (plan.format == gpu::Format::R8)
    filled.texels = repeated(std::uint8_t(texel * 255.0f + 0.5f), count);
  else if (plan.format == gpu::Format::R16)
    filled.texels = repeated(std::uint16_t(texel * 65535.0f + 0.5f), count);
  else if (plan.format == gpu::Format::Rgba8)
    filled.texels = repeated(glm::u8vec4(0, 0, 0, std::uint8_t(texel * 255.0f + 0.5f)), count);
  else
    filled.texels = repeated(texel, count);
  writeSlot(volume, place, filled);
}

void placeRow(SlotRow& row, const GpuVolume& volume, const SlotPlace& place, glm::ivec3 origin) {
  row.values = row.gradients = place.corner - origin;
  if (volume.packing == Packing::None) return;
  glm::ivec3 step(1, kSlotEdge, kSlotEdge * kSlotEdge);
  glm::ivec3 before = origin * step;
  row.values = {int(place.element) - before.x - before.y - before.z, step.y, step.z};
}

void placeCoarseRow(SlotRow& row, const GpuVolume& volume, glm::ivec3 dims) {
  row.values = row.gradients = glm::ivec3(0);
  if (volume.packing != Packing::None) row.values = {0, dims.x, dims.x * dims.y};
}

}  // namespace velum::render
