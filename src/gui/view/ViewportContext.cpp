// The view's GL context: how it comes, goes with a window, and is made anew where the driver has lost it.
#include <QTimer>
#include <utility>

#include "core/Error.h"
#include "gpu/Loss.h"
#include "gui/kit/CoreWords.h"
#include "gui/view/CoarseScale.h"
#include "gui/view/PreparingVeil.h"
#include "gui/view/Viewport.h"

namespace velum::gui {

namespace {

constexpr int kDriverPauseMs = 1000;
constexpr int kLossesCountMs = 60'000;  // losses that far apart have not the same cause

}  // namespace

ViewSurface::Listener Viewport::listener() {
  return {.made = [this] { makeRenderer(); },
          .leaves = [this] { release(); },
          .failed =
              [this](const QString& words) {
                QMetaObject::invokeMethod(
                    this, [this, words] { emit failed(words); }, Qt::QueuedConnection);
              },
          .resized = [this] { resizePicture(); },
          .paints = [this] { return bindContext(); },
          .painted =
              [this] {
                if (gpu::isContextLost()) noteLoss();  // while the picture stood
                mShownCount += std::exchange(mIsFresh, false) ? 1 : 0;
              }};
}

/// In a context that has just been made.
void Viewport::makeRenderer() {
  gpu::Context& context = *mSurface->context();
  mRenderer = std::make_unique<render::Renderer>(context);
  if (mCoarseScale == 0) mCoarseScale = context.limits().isSoftware ? kFirstScaleSoftware : kFirstScaleHardware;
  startAnew();
}

/// Gives back everything on the GPU while the context still lives, as the widget is deleted or moves to another window,
/// or was lost; what was in that is gone with it.
void Viewport::release() {
  mSectionTimer.stop();
  mRestTimer.stop();
  mPickTimer.stop();
  mLevelTimer.stop();
  mPauseTimer.stop();
  if (!mSurface->context()) return;
  bool isLost = !mSurface->bind() || gpu::isContextLost();
  if (isLost) mSurface->forget();
  mTellsLoss = mTellsLoss || isLost;
  mVeil->forget();
  mFrame = {};  // it holds sheets
  mSession.releaseGpu();
  mRenderer.reset();
  mSurface->drop();
  mHasPicture = false;
  mPending = true;
  mStage = Stage::Idle;
}

void Viewport::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (std::exchange(mHasGivenUp, false)) noteLoss();
  if (bindContext() && mSurface->size() == glm::ivec2(0)) resizePicture();
  if (mRenderer) mSectionTimer.start();  // what stood still while nobody saw it
}

void Viewport::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  mSurface->widget().resize(size());
}

void Viewport::renewContext() {
  release();
  mSurface->renew();
  if (bindContext() && mSurface->size() == glm::ivec2(0)) resizePicture();
}

/// @return false where there is no context, or it was lost, which is seen to
bool Viewport::bindContext() {
  if (!mSurface->context() || mIsLost) return false;
  if (mSurface->bind()) return true;
  noteLoss();
  return false;
}

/// Does some work with the driver. Where that fails, as for want of memory, it is said, the picture stands, and the
/// next change of the scene tries anew. @return false when it has failed, or there is no driver, see bindContext()
bool Viewport::tries(const std::function<void()>& work) {
  if (!bindContext()) return false;
  try {
    work();
    return true;
  } catch (const Error& error) {
    if (gpu::isContextLost()) {
      noteLoss();
      return false;
    }
    mStage = Stage::Idle;
    mPending = mAwaitsCounts = false;
    mVeil->fail();
    emit failed(inWords(error.what()));
    return false;
  }
}

/// The driver has lost the context: there will be another one as soon as nobody is at work in this one.
void Viewport::noteLoss() {
  mSectionTimer.stop();
  if (mSinceLoss.isValid() && mSinceLoss.elapsed() > kLossesCountMs) mLosses = 0;
  mSinceLoss.start();
  if (!std::exchange(mIsLost, true)) QMetaObject::invokeMethod(this, &Viewport::recover, Qt::QueuedConnection);
}

void Viewport::recover() {
  mIsLost = false;
  if (++mLosses <= gpu::kMostLosses) {
    renewContext();
    // A driver that is still being reset makes none.
    mIsLost = !mSurface->context() && isVisible();
    if (mIsLost) QTimer::singleShot(kDriverPauseMs * mLosses, this, &Viewport::recover);
    return;
  }
  release();
  mHasGivenUp = true;
  mLosses = 0;
  mVeil->await(mDocument.shown());
  mVeil->fail();
  try {
    gpu::giveUpAfterLosses();
  } catch (const Error& error) {
    emit failed(inWords(error.what()));
  }
  tellProgress();
}

/// The old picture stands in, stretched, until the new one is there.
void Viewport::resizePicture() {
  if (!mSurface->context()) return;
  if (!mSurface->resize(deviceSize())) return gpu::isContextLost() ? noteLoss() : failForSize();
  startAnew();
}

}  // namespace velum::gui
