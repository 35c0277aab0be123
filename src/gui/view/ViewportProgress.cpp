// What the view tells of how far its picture is.
#include "gui/view/PreparingVeil.h"
#include "gui/view/Viewport.h"

namespace velum::gui {

namespace {

constexpr int kTellMs = 250;  // how often the status line is told: the window is composed anew for each word

}  // namespace

/// Without memory for a picture of the view's size.
void Viewport::failForSize() {
  mVeil->fail();
  emit failed(
      tr("The driver has no memory for a picture of this size: make the window smaller, or close other programs "
         "that draw"));
}

void Viewport::tellProgress() {
  if (mToldStage == mStage && mStage != Stage::Idle && mSinceTold.elapsed() < kTellMs) return;
  mToldStage = mStage;
  mSinceTold.start();
  switch (mStage) {
    case Stage::Idle:
      // A sheet or a region that is being computed will change the picture.
      if (mVeil->hasFailed())
        emit refined(0.0, tr("No picture"));
      else if (auto levels = mSession.levels().fractionDone(); levels && isVisible() && !mPending)
        tellLevels(*levels);
      else if (isVisible() && (mPending || mSession.isOnItsWay()))
        emit refined(0.0, tr("Preparing"));
      else
        emit refined(1.0, {});
      break;
    case Stage::Coarse:
      emit refined(0.0, mRenderer->fractionDone() < 1.0 ? tr("Preparing") : tr("Preview"));
      break;
    case Stage::Half:
      emit refined(0.0, tr("Preview"));
      break;
    case Stage::Full:
      emit refined(mRenderer->fractionDone(), tr("Refining"));
      break;
  }
}

/// The picture stands, and will be drawn anew with the levels of detail that are being made.
void Viewport::tellLevels(double fraction) {
  emit refined(fraction, tr("Levels of detail"));
  mLevelTimer.start(kTellMs);
}

}  // namespace velum::gui
