#include "render/passes/Patches.h"

#include <algorithm>

#include "render/FrameSetup.h"
#include "render/residency/Residency.h"

namespace velum::render {

namespace {

constexpr int kTile = 32;  ///< pixels along an edge: a few of the groups that rays are cast in

/// Tiles of a rectangle of the window, some of them marked.
class Tiles {
 public:
  explicit Tiles(glm::ivec4 rect)
      : mRect(rect),
        mCount((glm::ivec2(rect.z, rect.w) + kTile - 1) / kTile),
        mMarks(std::size_t(mCount.x * mCount.y)) {}

  /// Marks all that overlap a rectangle.
  void mark(glm::ivec4 rect) {
    glm::ivec2 low = glm::max(glm::ivec2(rect), glm::ivec2(mRect)) - glm::ivec2(mRect);
    glm::ivec2 high =
        glm::min(glm::ivec2(rect) + glm::ivec2(rect.z, rect.w) - glm::ivec2(mRect), glm::ivec2(mRect.z, mRect.w));
    if (glm::any(glm::greaterThanEqual(low, high))) return;
    for (int y = low.y / kTile; y <= (high.y - 1) / kTile; ++y)
      for (int x = low.x / kTile; x <= (high.x - 1) / kTile; ++x) mMarks[std::size_t(y * mCount.x + x)] = true;
  }

  /// Runs of marked tiles, row by row.
  std::vector<glm::ivec4> rects() const {
    std::vector<glm::ivec4> rects;
    for (int y = 0; y < mCount.y; ++y)
      for (int x = 0; x < mCount.x; ++x) {
        int from = x;
        while (x < mCount.x && mMarks[std::size_t(y * mCount.x + x)]) ++x;
        if (x == from) continue;
        glm::ivec2 low = kTile * glm::ivec2(from, y);
        glm::ivec2 size = glm::min(kTile * glm::ivec2(x - from, 1), glm::ivec2(mRect.z, mRect.w) - low);
        rects.emplace_back(glm::ivec2(mRect) + low, size);
      }
    return rects;
  }

 private:
  glm::ivec4 mRect;
  glm::ivec2 mCount;
  std::vector<bool> mMarks;
};

}  // namespace

bool canPatch(const FrameData& data) {
  return !(data.params.flags & shared::kFlagFinish) && !isModelDrawn(data.frame.scene);
}

std::vector<glm::ivec4> changedRects(const FrameData& data) {
  glm::ivec4 all = drawnRect(data);
  if (all.z <= 0 || all.w <= 0) return {};
  auto boxes = data.residency->changes();
  if (!boxes) return {all};
  Tiles tiles(all);
  for (const Residency::TexBox& box : *boxes) tiles.mark(rectOfBox(data.params, data.frame, box.low, box.high));
  return tiles.rects();
}

}  // namespace velum::render
