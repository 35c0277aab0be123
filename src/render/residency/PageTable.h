#pragma once
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "gpu/Buffer.h"
#include "gpu/Texture.h"
#include "render/residency/PageGrid.h"
#include "shared/bindings.h"

namespace velum::render {

/// By page of a level: the slot in which its voxels are, those of that level or of a coarser one. The pages are the
/// bricks of the level. Kept here and on the GPU. GL thread.
class PageTable {
 public:
  /// Makes the table of a level, with all pages in slot 0.
  void reset(const PageGrid& grid, int level);
  int level() const { return mLevel; }
  glm::ivec3 size() const { return mSize; }

  std::size_t indexOf(glm::ivec3 page) const {
    return (std::size_t(page.z) * std::size_t(mSize.y) + std::size_t(page.y)) * std::size_t(mSize.x) +
           std::size_t(page.x);
  }
  glm::ivec3 pageAt(std::size_t index) const;
  std::uint32_t slot(std::size_t index) const { return mSlots[index]; }
  void set(std::size_t index, std::uint32_t slot);

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
  std::vector<std::uint32_t> mSlots;
  std::size_t mFirstChanged = 0, mEndChanged = 0;
  gpu::Buffer mBuffer;
  gpu::Texture mTexture;
};

}  // namespace velum::render
