#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "gpu/Buffer.h"
#include "gpu/Texture.h"

namespace velum::shared {
struct InstanceView;
}

namespace velum::model {

/// Which copies of a model have a slot: their instances have numbers, slot by slot, and are looked at one by one. Where
/// copies are few, each has the slot of its own number. In a crowd only those have one that are seen from near by; the
/// others are drawn as wholes, and have a number each, from InstanceView::firstWhole on. GL thread.
class CopySlots {
 public:
  /// Gives slots to copies. Who had one and is wanted again keeps it, so that what was seen before stays known.
  /// @param view  copies, step and grid  @param wanted  copies, each once; as many as there are slots at most
  /// @param isCrowd  false: `wanted` have slots in their order
  void place(const shared::InstanceView& view, std::span<const std::uint32_t> wanted, bool isCrowd);
  /// How many slots are in use, from the first on.
  int used() const { return int(mCopies.size()); }
  std::uint32_t copyIn(std::uint32_t slot) const { return mCopies[slot]; }
  /// All slots in use, the nearest first as a view sees them.
  std::vector<std::uint32_t> byDepth(const shared::InstanceView& view) const;
  void bind() const;

 private:
  std::vector<std::uint32_t> mCopies;
  gpu::Buffer mRows, mBits;  ///< Shift and number by slot; a bit a copy that has a slot.
  gpu::Texture mRowTexels, mBitTexels;
};

}  // namespace velum::model
