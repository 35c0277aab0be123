#include "model/CopySlots.h"

#include <algorithm>
#include <bit>
#include <glm/glm.hpp>
#include <numeric>
#include <unordered_map>

#include "model/CopyBlocks.h"
#include "shared/bindings.h"
#include "shared/instance.h"

namespace velum::model {

namespace {

/// The copies that had slots stay where they are wanted; others come into the slots that get free, then behind.
std::vector<std::uint32_t> slotsFor(const std::vector<std::uint32_t>& before, std::span<const std::uint32_t> wanted) {
  std::unordered_map<std::uint32_t, bool> isPlaced;
  for (std::uint32_t copy : wanted) isPlaced.emplace(copy, false);
  std::vector<std::uint32_t> slots;
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < std::min(before.size(), wanted.size()); ++i) {
    slots.push_back(before[i]);
    if (auto found = isPlaced.find(before[i]); found != isPlaced.end())
      found->second = true;
    else
      open.push_back(i);
  }
  auto next = open.begin();
  for (std::uint32_t copy : wanted) {
    if (isPlaced[copy]) continue;
    if (next != open.end())
      slots[*next++] = copy;
    else
      slots.push_back(copy);
  }
  return slots;
}

}  // namespace

void CopySlots::place(const shared::InstanceView& view, std::span<const std::uint32_t> wanted, bool isCrowd) {
  if (isCrowd)
    mCopies = slotsFor(mCopies, wanted);
  else
    mCopies.assign(wanted.begin(), wanted.end());
  std::vector<glm::vec4> rows;
  for (std::uint32_t copy : mCopies) rows.emplace_back(copyShift(view, copy), std::bit_cast<float>(copy));
  if (rows.empty()) rows.emplace_back(0.0f);
  mRows = gpu::Buffer("slots of copies", std::span<const glm::vec4>(rows));
  mRowTexels = gpu::Texture::makeOfBuffer("slots of copies", gpu::Format::Rgba32f, mRows);
  std::vector<std::uint32_t> bits(isCrowd ? std::size_t(view.allCopies + 31) / 32 : 1);
  if (isCrowd)
    for (std::uint32_t copy : mCopies) bits[copy / 32] |= 1u << copy % 32;
  mBits = gpu::Buffer("copies with slots", std::span<const std::uint32_t>(bits));
  mBitTexels = gpu::Texture::makeOfBuffer("copies with slots", gpu::Format::R32ui, mBits);
}

std::vector<std::uint32_t> CopySlots::byDepth(const shared::InstanceView& view) const {
  std::vector<std::uint32_t> order(mCopies.size());
  std::iota(order.begin(), order.end(), 0u);
  std::vector<float> depths;
  for (std::uint32_t copy : mCopies) {
    glm::vec3 q = glm::vec3(view.copySphere) + copyShift(view, copy) - glm::vec3(view.eye);
    depths.push_back(view.isOrthographic != 0 ? glm::dot(q, glm::vec3(view.forward)) : glm::length(q));
  }
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return depths[a] < depths[b]; });
  return order;
}

void CopySlots::bind() const {
  mRowTexels.bindSampler(shared::kSlotUnit);
  mBitTexels.bindSampler(shared::kSlottedUnit);
}

}  // namespace velum::model
