// The sheets of membranes in the 3D view's slices: what is computed beside, how far they go at a time, who hears of it.
#include "Viewport.h"
#include "kit/Job.h"

namespace velum::gui {

namespace {

constexpr double kSheetMs = 8.0;  // beside a coarse picture's 28: events are still answered within 50
constexpr int kTellMs = 200;

}  // namespace

/// Something may be due that no picture waits for.
void Viewport::wakeSheets() {
  bool isDue = !mPlayer.isSettled() || mPlayer.hasRests() || mPlayer.indices() != mIndicesTold ||
               mPlayer.shownCount() != mSheetsShown;
  if (mRenderer && isDue && !mSliceTimer.isActive() && !mPauseTimer.isActive()) mSliceTimer.start();
}

/// A slice of the sheets' work. @return true when more is due at once
bool Viewport::driveSheets() {
  startSheetWork();
  mPlayer.advance(kSheetMs);
  if (mPlayer.shownCount() != mSheetsShown) {
    mPending = true;
    mRestTimer.stop();
  }
  if (auto rests = mPlayer.takeRests(); !rests.empty())
    mDocument.complete([&](scene::Scene& scene) {
      for (auto& rest : rests)
        if (scene::Cut* cut = scene::findCut(scene, rest.cut); cut && cut->membrane) cut->membrane->shape = rest.shape;
    });
  startSheetWork();  // the figures of what has just come to rest
  tellSheets();
  return mPlayer.isMoving();
}

void Viewport::startSheetWork() {
  if (mSheetJob && mPlayer.wantsCancel()) mSheetJob->cancel();
  if (mSheetJob) return;
  session::MembranePlayer::Work work = mPlayer.nextWork();
  if (!work) return;
  auto finish = std::make_shared<session::MembranePlayer::Finish>();
  mSheetJob = std::make_unique<Job>([finish, work = std::move(work)](Progress& progress) { *finish = work(progress); },
                                    nullptr);
  connect(mSheetJob.get(), &Job::finished, this, [this, finish](bool done, const QString& error) {
    mSheetJob.release()->deleteLater();
    mPlayer.endWork(done ? *finish : session::MembranePlayer::Finish(), error.toStdString());
    wakeSheets();
    tellSheets();
  });
  mSheetJob->start();
}

void Viewport::tellSheets() {
  if (auto indices = mPlayer.indices(); indices != mIndicesTold) {
    mIndicesTold = std::move(indices);
    emit sheetsMoved();
  }
  bool settled = mPlayer.isSettled();
  if (settled && mSheetsWereSettled) return;
  if (settled == mSheetsWereSettled && mSinceSheetsTold.isValid() && mSinceSheetsTold.elapsed() < kTellMs) return;
  mSheetsWereSettled = settled;
  mSinceSheetsTold.start();
  emit sheetsTold();
}

void Viewport::playMembranes(bool play) {
  mPlayer.setPlaying(play);
  wakeSheets();
  emit sheetsTold();
}

void Viewport::stepMembranes() {
  if (!bindContext()) return;
  mPlayer.setPlaying(false);
  mPlayer.stepOnce();
  wakeSheets();
  emit sheetsTold();
}

void Viewport::resetMembrane(int cut) {
  mPlayer.reset(cut);
  wakeSheets();
  emit sheetsTold();
}

}  // namespace velum::gui
