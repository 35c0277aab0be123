#include "render/passes/BrickPass.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "render/WorkQueue.h"

namespace velum::render {

namespace {

constexpr const char* kBricks = "Bricks";
constexpr int kCoarseMarks = 8, kFineMarks = 3;      // rays leave marks on pages through one of so many pixels a side
constexpr double kTakeMs = 8.0;                      // of taking what has come
constexpr double kBlindMs = 500.0;                   // somebody who looks on sees nothing new for so long
constexpr std::chrono::milliseconds kBrickPause{1};  // between two questions whether bricks have come

}  // namespace

void BrickPass::addSteps(const FrameData& data, Then bind, Then cast) {
  mData = &data;
  mBind = std::move(bind);
  mCast = std::move(cast);
  // The same view with other cuts, light or colours meets mostly what the last one met: drawing it tells.
  bool isSameView = mHadAll && mView == data.frame.scene.camera && mViewSize == data.frame.pictureSize;
  mHadAll = false;
  mView = data.frame.scene.camera;
  mViewSize = data.frame.pictureSize;
  if (isSameView)
    mQueue.add(kBricks, [this] { mCast(); });
  else
    addRound(kCoarseMarks);
}

/// First the bricks that rays of few pixels meet; when these have what they want, those of more pixels. What the rest
/// of the pixels and samples meet is found by drawing them.
void BrickPass::addRound(int pixelStep) {
  mQueue.add("Setup", [this] {
    mBind();
    mData->residency->clearSeen();
  });
  mQueue.add(mRayCast, [this, pixelStep] {
    mInputs.writeParams(*mData, 0);
    mRayCast.markPages(*mData, pixelStep);
  });
  mQueue.add(kBricks, [this] { mData->residency->gather(whatShows()); });
  mQueue.addUntilDone(kBricks, [this] { return take(); });
  mQueue.add(kBricks, [this, pixelStep] {
    bool hasNews = mData->residency->hasNews();
    takeNews();
    // What has come may have let rays through to others.
    if (!isPatient() || (!hasNews && pixelStep == kFineMarks))
      mCast();
    else
      addRound(hasNews ? pixelStep : kFineMarks);
  });
}

/// Waits for bricks, but not longer than somebody who looks on likes to see nothing new.
bool BrickPass::take() {
  if (mData->residency->receive(kTakeMs, whatShows()) == 0 || !isPatient()) return true;
  std::this_thread::sleep_for(kBrickPause);
  mQueue.rest();
  return false;
}

void BrickPass::takeNews() {
  if (mData->residency->hasNews()) mData->residency->updateCells();
  mSkip.addSteps(*mData, 0, mQueue);
}

void BrickPass::addCheck(const FrameData& data, Then again) {
  mQueue.add(kBricks, [this, &data, again = std::move(again)] {
    mDrawnAt = Clock::now();
    mHadAll = data.residency->gather(whatShows()) == 0 && !data.residency->hasNews();
    if (mHadAll) return;
    mQueue.dropRest();
    mQueue.addUntilDone(kBricks, [this] { return take(); });
    mQueue.add(kBricks, [this, again] {
      takeNews();
      mQueue.add("Setup", mBind);
      again();
      mData->residency->noteDrawn();
    });
  });
}

void BrickPass::addStepsAgain() { addRound(kFineMarks); }

bool BrickPass::isPatient() const {
  return mWaits || msSince(mDrawnAt) < (mRayCast.progress().samples > 0 ? kBlindMs : 0.0);
}

/// Rays stop for all values where they leap over nothing, look for the largest, or show the data itself on a face.
Residency::MayShow BrickPass::whatShows() const {
  std::uint32_t flags = mData->params.flags;
  bool isAll = mData->frame.scene.rayCast.mode == scene::RenderMode::Mip || !(flags & shared::kFlagSkipEmpty) ||
               (flags & (shared::kFlagFaces | shared::kFlagInlays));
  if (isAll) return [](glm::vec2) { return true; };
  return mSkip.whatShows();
}

}  // namespace velum::render
