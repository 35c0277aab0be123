#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "gpu/Buffer.h"
#include "gpu/Texture.h"
#include "render/residency/PageGrid.h"
#include "shared/bindings.h"
#include "shared/frame.h"

namespace velum::render {

/// Where the voxels of a slot lie: place among the voxels of a level, whose middles are at whole numbers = tex * scale
/// + first.
struct SlotRow {
  glm::vec3 scale{0.0f}, first{0.0f};
  glm::vec3 last{0.0f};                ///< Voxel of the level.
  glm::ivec3 values{0}, gradients{0};  ///< As bricks.glsl has places.
};

/// By page of a level: the slot in which its voxels are, those of that level or of a coarser one; and where slots lie.
/// The pages are the bricks of the level. Kept here and on the GPU. GL thread.
class PageTable {
 public:
  /// Makes the table of a level, with all pages in slot 0. Where slots lie must then be set anew.
  void reset(const PageGrid& grid, int level, std::size_t slots);
  int level() const { return mLevel; }
  glm::ivec3 size() const { return mSize; }

  std::size_t indexOf(glm::ivec3 page) const {
    return (std::size_t(page.z) * std::size_t(mSize.y) + std::size_t(page.y)) * std::size_t(mSize.x) +
           std::size_t(page.x);
  }
  glm::ivec3 pageAt(std::size_t index) const;
  std::uint32_t slot(std::size_t index) const { return mSlots[index]; }
  void set(std::size_t index, std::uint32_t slot);
  /// Pages whose slot has changed since forgetChanges(), some of them more than once; nothing where they are too many
  /// to be told.
  const std::optional<std::vector<std::size_t>>& changes() const { return mChanges; }
  void forgetChanges() { mChanges.emplace(); }
  /// Says where a slot lies; sent at once.
  void setRow(std::uint32_t slot, const SlotRow& row);
  /// Where pages begin in the table that shaders read, rows of four words.
  std::size_t firstRow() const { return mSlotCount * shared::kSlotRows; }

  /// The pages that a brick covers: the first, and one past the last, along each axis. Empty for a brick of a finer
  /// level.
  struct Pages {
    glm::ivec3 low{0}, high{0};
  };
  Pages covered(const PageGrid& grid, const PageBrick& brick) const;

  /// Sends what has changed.
  void upload();
  void bind() const { mTexture.bindSampler(shared::kPageUnit); }

 private:
  int mLevel = -1;
  glm::ivec3 mSize{0};
  std::vector<std::uint32_t> mSlots;  ///< by page
  std::size_t mSlotCount = 0;
  std::size_t mFirstChanged = 0, mEndChanged = 0;  ///< that shaders do not see yet
  std::optional<std::vector<std::size_t>> mChanges;
  gpu::Buffer mBuffer;
  gpu::Texture mTexture;
};

}  // namespace velum::render
