// The players of the session in the 3D view's sections: how far they go at a time, who hears of it.
#include "gui/view/Viewport.h"

namespace velum::gui {

namespace {

constexpr double kSheetMs = 8.0;  // beside a coarse picture's 28: events are still answered within 50
constexpr int kTellSheetsMs = 200;

}  // namespace

/// Starts the timer, as sheets may need work although no picture is being drawn. The picture that is there is no longer
/// one of sheets that have been moved.
void Viewport::wakeSheets() {
  if (mRenderer && mSession.shownCount() != mSheetsShown) {
    mPending = true;
    mRestTimer.stop();
  }
  bool isDue = !mSession.isStill() || membranes().indices() != mIndicesTold || mSession.shownCount() != mSheetsShown;
  if (mRenderer && isDue && !mSectionTimer.isActive() && !mPauseTimer.isActive()) mSectionTimer.start();
}

void Viewport::playersTold() {
  wakeSheets();
  tellSheets();
  if (mRenderer) tellProgress();
  emit playersHeard();
}

/// A section of the sheets' work. @return true when more is due at once
bool Viewport::driveSheets() {
  bool isMoving = mSession.advance(kSheetMs);
  if (mSession.shownCount() != mSheetsShown) {
    mPending = true;
    mRestTimer.stop();
  }
  tellSheets();
  return isMoving;
}

void Viewport::tellSheets() {
  if (auto indices = membranes().indices(); indices != mIndicesTold) {
    mIndicesTold = std::move(indices);
    emit sheetsMoved();
  }
  bool settled = membranes().isSettled();
  if (settled && mSheetsWereSettled) return;
  if (settled == mSheetsWereSettled && mSinceSheetsTold.isValid() && mSinceSheetsTold.elapsed() < kTellSheetsMs) return;
  mSheetsWereSettled = settled;
  mSinceSheetsTold.start();
  emit sheetsTold();
}

void Viewport::playMembranes(bool play) {
  mSession.membranes().setPlaying(play);
  wakeSheets();
  emit sheetsTold();
}

void Viewport::stepMembranes() {
  mSession.membranes().setPlaying(false);
  if (tries([this] { mSession.membranes().stepOnce(); })) wakeSheets();
  tellSheets();
  emit sheetsTold();
}

void Viewport::resetMembrane(int cut) {
  mSession.membranes().reset(cut);
  wakeSheets();
  emit sheetsTold();
}

}  // namespace velum::gui
