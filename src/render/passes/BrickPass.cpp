#include "render/passes/BrickPass.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "render/WorkQueue.h"

namespace velum::render {

namespace {

/// Structures are as fine as the finest level wherever they lie: steps between which thin ones would fall stay short.
void lengthenSteps(FrameData& data) {
  glm::dvec2 found = data.labelUse == LabelUse::None ? data.residency->coarsening() : glm::dvec2(0.0);
  data.params.coarsening = {found.x / data.unit, found.y, 0.0, 0.0};
}

constexpr const char* kBricks = "Bricks";
constexpr int kCoarseMarks = 8, kFineMarks = 3;  // rays leave marks on pages through one of so many pixels a side
constexpr double kTakeMs = 8.0;                  // of taking what has come
constexpr double kBlindMs = 500.0, kMostBlindMs = 20e3;  // somebody who looks on sees nothing new for so long,
constexpr double kBlindShare = 0.25;                     // and longer where a sample takes long to draw: a part of that
constexpr std::chrono::milliseconds kBrickPause{1};      // between two questions whether bricks have come

}  // namespace

void BrickPass::addSteps(FrameData& data, Then bind, Then cast, Then restart) {
  mData = &data;
  mBind = std::move(bind);
  mCast = std::move(cast);
  mRestart = std::move(restart);
  // The same view with other cuts, light or colours meets mostly what the last one met: drawing it tells.
  bool isSameView = mHadAll && mView == data.frame.scene.camera && mViewSize == data.frame.pictureSize;
  mHadAll = false;
  mView = data.frame.scene.camera;
  mViewSize = data.frame.pictureSize;
  mDrawnAt = Clock::now();
  if (isSameView)
    mQueue.add(kBricks, [this] { mCast(); });
  else
    addRound(kCoarseMarks);
}

/// First the bricks that rays of few pixels meet; when these have what they want, those of more pixels. What the rest
/// of the pixels and samples meet is found by drawing them.
void BrickPass::addRound(int pixelStep) {
  mQueue.add("Setup", [this] {
    lengthenSteps(*mData);
    mBind();
    mData->residency->clearSeen();
  });
  mQueue.add(mRayCast, [this, pixelStep] {
    mInputs.writeParams(*mData, 0);
    mRayCast.markPages(*mData, pixelStep);
  });
  addGathering();
  mQueue.addUntilDone(kBricks, [this, pixelStep] {
    if (mData->residency->isTooFine()) {
      mData->residency->keepCoarse();
      mRestart();
      return false;  // what comes first now is the new frame's
    }
    bool hasNews = mData->residency->hasNews();
    takeNews();
    // What has come may have let rays through to others.
    if (!isPatient() || (!hasNews && pixelStep == kFineMarks))
      mCast();
    else
      addRound(hasNews ? pixelStep : kFineMarks);
    return true;
  });
}

/// Asks for bricks and waits for them; anew while those asked for are only to tell how many of all will be seen.
void BrickPass::addGathering() {
  mQueue.add(kBricks, [this] { mData->residency->gather(whatShows()); });
  mQueue.addUntilDone(kBricks, [this] {
    if (!take()) return false;
    if (!mData->residency->isSampling() || mData->residency->streaming().missing > 0) return true;
    mData->residency->gather(whatShows());
    return false;
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

void BrickPass::beginCasting(FrameData& data) const {
  lengthenSteps(data);
  // A group of long steps reaches farther than bricks of finer voxels do; samples by themselves ask each its own. Where
  // somebody looks on what is finer stays, if there is room.
  bool drops = mWaits || data.residency->isShort();
  if (!data.frame.isPreview && data.residency->hasFiner(drops) && !drops) data.params.coarsening = glm::vec4(0.0f);
  data.residency->clearSeen();
  data.residency->noteDrawn();
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
  double least = mRayCast.progress().samples > 0 ? kBlindMs : 0.0;
  return mWaits || msSince(mDrawnAt) < std::clamp(kBlindShare * mRayCast.sampleMs(), least, kMostBlindMs);
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
