#include "render/passes/RayCastPass.h"

#include <algorithm>
#include <utility>

#include "gpu/Strided.h"
#include "render/WorkQueue.h"
#include "render/residency/Residency.h"

namespace velum::render {

namespace {

// A piece takes so long: many times what handing it over and waiting for it costs, in which the driver's threads rest,
// and less than what a window notices.
constexpr double kPieceMs = 16.0, kPreviewPieceMs = 6.0;
constexpr double kLongestPieceMs = 40.0;                   ///< Were all of it like the slowest of the last picture.
constexpr double kMostGroups = 32768;                      ///< What every driver takes in one dimension.
constexpr int kFirstSoftware = 64, kFirstHardware = 4096;  // groups, of which nothing is known yet

RayVariant rayVariantOf(const FrameData& data) {
  RayVariant variant{dataVariantOf(data), false};
  variant.hasGradients = data.volume && data.volume->gradient && usesGradients(variant.data);
  return variant;
}

}  // namespace

RayCastPass::RayCastPass(Gbuffer& target, bool isSoftware)
    : Pass("RayCast"), mTarget(target), mFirst(isSoftware ? kFirstSoftware : kFirstHardware) {}

bool RayCastPass::isKnown(const FrameData& data) const { return mPrograms.contains(rayVariantOf(data)); }

void RayCastPass::prepare(FrameData& data) {
  RayVariant variant = rayVariantOf(data);
  mProgram = &mPrograms.find(variant, [&] { return gpu::Program({"render/ray_cast.comp"}, definesOf(variant)); });
  mTarget.resize(data.frame.windowSize, (data.params.flags & shared::kFlagFinish) != 0);
  mPace.begin(data.frame.isPreview ? kPreviewPieceMs : kPieceMs);
}

void RayCastPass::Pace::begin(double pieceMs) {
  wantedMs = pieceMs;
  // A picture begins as carefully as if all of it were like the slowest piece of the one before.
  slowest = slowestNow > 0 ? slowestNow : slowest;
  last = slowest;
  slowestNow = 0;
  most = 0;
  handedOver.clear();
}

void RayCastPass::Pace::took(double ms) {
  if (handedOver.empty()) return;
  int groups = handedOver.front();
  handedOver.pop_front();
  if (groups == 0) return;
  last = ms / groups;
  slowestNow = std::max(slowestNow, last);
}

/// As many groups as the last ones would take the time that is wanted for. What they hide may be slower: never more
/// than twice as many as before, nor more than are quick enough were they the slowest that are known.
int RayCastPass::Pace::next(int first) {
  double groups = most == 0 && !(last > 0) ? first : most == 0 ? wantedMs / last : 2.0 * most;
  if (last > 0) groups = std::min(groups, wantedMs / last);
  double known = std::max(slowest, slowestNow);
  if (known > 0) groups = std::min(groups, kLongestPieceMs / known);
  return std::clamp(int(std::min(groups, kMostGroups)), 1, int(kMostGroups));
}

void RayCastPass::took(double ms) {
  if (mMarkedShare > 0 && !mPace.handedOver.empty() && mPace.handedOver.front() == 0)
    mSampleMs = ms / std::exchange(mMarkedShare, 0.0);
  mPace.took(ms);
}

void RayCastPass::addSteps(const FrameData& data, int sample, WorkQueue& queue) {
  // Where neither the volume's box nor a surface can be, rays have nothing to do.
  glm::ivec4 covered = drawnRect(data);
  queue.addUntilDone(
      *this, [this, &data, sample, covered] { return castNext(data, sample, covered); },
      [this, covered] { return covered.w > 0 ? double(mNext.y) / covered.w : 1.0; });
}

/// The next piece of a rectangle, after which mNext stands where the one after it begins: full strips of rows where
/// that is not too much, else a part of one.
glm::ivec4 RayCastPass::nextPiece(glm::ivec4 rect) {
  constexpr int kEdge = shared::kTileGroup;
  int wanted = mPace.next(mFirst), across = (rect.z + kEdge - 1) / kEdge;
  if (mNext.x == 0) mStripRows = std::min(std::max(1, wanted / across) * kEdge, rect.w - mNext.y);
  int down = (mStripRows + kEdge - 1) / kEdge;
  int columns = std::min(std::max(1, wanted / down) * kEdge, rect.z - mNext.x);
  glm::ivec4 piece(rect.x + mNext.x, rect.y + mNext.y, columns, mStripRows);
  int groups = (columns + kEdge - 1) / kEdge * down;
  mPace.most = std::max(groups, mPace.most);
  mPace.handedOver.push_back(groups);
  mNext.x += columns;
  if (mNext.x >= rect.z) mNext = {0, mNext.y + mStripRows};
  return piece;
}

void RayCastPass::redo() {
  if (mProgress.samples > 1) mTarget.restoreColor({0, 0, mTarget.size()});
  mProgress = {std::min(mProgress.samples, 1), 0, {0, 0}, 0};
  mNext = {0, 0};
}

void RayCastPass::addPatches(const FrameData& data, int sample, std::vector<glm::ivec4> rects, WorkQueue& queue) {
  for (glm::ivec4 rect : rects)
    queue.addUntilDone(*this, [this, &data, sample, rect] {
      glm::ivec4 piece = nextPiece(rect);
      if (sample > 0) mTarget.restoreColor(piece);
      castTile(data, piece);
      if (mNext.y < rect.w) return false;
      mNext = {0, 0};
      return true;
    });
}

/// Casts the next piece. @return true when the sample is complete
bool RayCastPass::castNext(const FrameData& data, int sample, glm::ivec4 covered) {
  bool isRedone = mProgress.samples > sample;
  if (sample == 0 && mNext == glm::ivec2(0) && !isRedone) mTarget.clear();
  if (covered.z <= 0 || covered.w <= 0) {
    mPace.handedOver.push_back(0);
    finishSample(sample);
    return true;
  }
  glm::ivec4 piece = nextPiece(covered);
  castTile(data, piece);
  if (!isRedone) {
    mProgress.strip = glm::ivec2(piece.y, piece.y + piece.w);
    mProgress.columnsDone = piece.x + piece.z;
  }
  if (mNext.x > 0) return false;
  if (!isRedone) mProgress.rowsDone = covered.y + mNext.y;
  if (mNext.y < covered.w) return false;
  finishSample(sample);
  return true;
}

void RayCastPass::finishSample(int sample) {
  mProgress = {sample + 1, 0, {0, 0}, 0};
  mNext = {0, 0};
}

void RayCastPass::markPages(const FrameData& data, int pixelStep) {
  glm::ivec4 covered = drawnRect(data);
  mPace.handedOver.push_back(0);
  mMarkedShare = 1.0 / (pixelStep * pixelStep);
  if (covered.z > 0 && covered.w > 0) castTile(data, covered, pixelStep);
}

void RayCastPass::castTile(const FrameData& data, glm::ivec4 rect, int pixelStep) {
  mTarget.bindImages();
  if (pixelStep == 1) mPixelsCast += std::size_t(rect.z) * std::size_t(rect.w);
  if (data.residency) data.residency->bindSeen();
  int edge = shared::kTileGroup * pixelStep;
  glm::ivec2 groups = (glm::ivec2(rect.z, rect.w) + edge - 1) / edge;
  // Groups beyond the tile have nothing to do.
  gpu::Strided order = gpu::stridedGroups(groups.x * groups.y);
  mProgram->set(0, rect);
  mProgram->set(1, data.frame.windowOrigin);
  mProgram->set(2, glm::ivec2(groups.x, order.stride));
  mProgram->set(3, pixelStep);
  gpu::dispatch(*mProgram, {order.count, 1, 1});
  gpu::barrier();
}

}  // namespace velum::render
