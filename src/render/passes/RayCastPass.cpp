#include "RayCastPass.h"

#include <algorithm>
#include <numeric>

#include "WorkQueue.h"

namespace velum::render {

namespace {

constexpr double kLongestTileMs = 8.0;
constexpr int kSmallestTile = 16;
constexpr int kSoftwareTile = 64, kHardwareTile = 512;

RayVariant variantOf(const FrameData& data) {
  RayVariant variant{dataVariantOf(data), false};
  variant.hasGradients = data.volume && data.volume->gradient && usesGradients(variant.data);
  return variant;
}

/// Near the golden section of their number, and with no common factor: any run of groups is spread over the tile.
int strideOf(int groups) {
  int stride = std::max(1, int(0.618 * groups));
  while (std::gcd(stride, groups) != 1) ++stride;
  return stride;
}

}  // namespace

RayCastPass::RayCastPass(Gbuffer& target, bool isSoftware)
    : Pass("RayCast"),
      mTarget(target),
      mLargestTile(isSoftware ? kSoftwareTile : kHardwareTile),
      mTileSize(mLargestTile) {}

void RayCastPass::prepare(FrameData& data) {
  RayVariant variant = variantOf(data);
  auto [program, isNew] = mPrograms.try_emplace(variant);
  if (isNew) program->second = gpu::Program({"render/ray_cast.comp"}, definesOf(variant));
  mProgram = &program->second;
  mTarget.resize(data.frame.windowSize);
  mIsPreview = data.frame.isPreview;
  if (!mIsPreview) adaptTileSize();
}

void RayCastPass::took(double ms) {
  if (!mIsPreview) mLongestTileMs = std::max(mLongestTileMs, ms);
}

/// Tiles of the next picture are such that none of them keeps the window waiting; no pixel depends on their size.
void RayCastPass::adaptTileSize() {
  if (mLongestTileMs > kLongestTileMs)
    mTileSize = std::max(kSmallestTile, mTileSize / 2);
  else if (mLongestTileMs < 0.2 * kLongestTileMs)
    mTileSize = std::min(mLargestTile, mTileSize * 2);
  mLongestTileMs = 0;
}

void RayCastPass::addSteps(const FrameData& data, int sample, WorkQueue& queue) {
  // Where neither the volume's box nor a surface can be, rays have nothing to do.
  glm::ivec4 covered = data.frame.scene.surfaces.empty() ? coveredRect(data.params, data.frame)
                                                         : glm::ivec4(0, 0, data.frame.windowSize);
  if (sample == 0) queue.add(*this, [this] { mTarget.clear(); });
  glm::ivec2 from(covered), to = from + glm::ivec2(covered.z, covered.w);
  for (int y = from.y; y < to.y; y += mTileSize)
    for (int x = from.x; x < to.x; x += mTileSize) {
      glm::ivec4 rect(x, y, std::min(mTileSize, to.x - x), std::min(mTileSize, to.y - y));
      bool isLastOfRow = x + mTileSize >= to.x;
      queue.add(*this, [this, &data, rect, isLastOfRow] {
        castTile(data, rect);
        mProgress.strip = {rect.y, rect.y + rect.w};
        mProgress.columnsDone = rect.x + rect.z;
        if (isLastOfRow) mProgress.rowsDone = rect.y + rect.w;
      });
    }
  queue.add(*this, [this, sample] { mProgress = {sample + 1, 0, {0, 0}, 0}; });
}

void RayCastPass::castTile(const FrameData& data, glm::ivec4 rect) {
  mTarget.bindImages();
  glm::ivec2 groups = (glm::ivec2(rect.z, rect.w) + shared::kTileGroup - 1) / shared::kTileGroup;
  mProgram->set(0, rect);
  mProgram->set(1, data.frame.windowOrigin);
  mProgram->set(2, strideOf(groups.x * groups.y));
  gpu::dispatch(*mProgram, glm::ivec3(groups, 1));
  gpu::barrier();
}

void RayCastPass::bind(const FrameData&) const { mTarget.bindImages(); }

}  // namespace velum::render
