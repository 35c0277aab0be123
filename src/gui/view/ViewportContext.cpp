// The view's GL context: how it comes from Qt, moves to another window, and is made anew where the driver has lost it.
#include <QCoreApplication>
#include <QEvent>
#include <QOpenGLContext>
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

void Viewport::initializeGL() {
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &Viewport::release, Qt::DirectConnection);
  try {
    mContext = gpu::Context::adopt(
        [](const char* name) {
          return reinterpret_cast<void*>(QOpenGLContext::currentContext()->getProcAddress(name));
        },
        [] { return static_cast<const void*>(QOpenGLContext::currentContext()); });
    mRenderer = std::make_unique<render::Renderer>(*mContext);
    bool isSoftware = mContext->limits().isSoftware;
    if (mCoarseScale == 0) mCoarseScale = isSoftware ? kFirstScaleSoftware : kFirstScaleHardware;
    startAnew();
  } catch (const Error& error) {
    mContext.reset();
    QMetaObject::invokeMethod(
        this, [this, text = inWords(error.what())] { emit failed(text); }, Qt::QueuedConnection);
  }
}

/// Gives back everything on the GPU while the context still lives, as the widget is deleted or moves to another window,
/// or was lost; what was in that is gone with it.
void Viewport::release() {
  mSectionTimer.stop();
  mRestTimer.stop();
  mPickTimer.stop();
  mLevelTimer.stop();
  mPauseTimer.stop();
  if (!mContext) return;
  makeCurrent();
  mContext->makeCurrent();
  bool isLost = QOpenGLContext::currentContext() != context() || gpu::isContextLost();
  if (isLost) mContext.reset();
  mTellsLoss = mTellsLoss || isLost;
  mShown.reset();
  mVeil->forget();
  mFrame = {};  // it holds sheets
  mSession.releaseGpu();
  mRenderer.reset();
  mContext.reset();
  mHasPicture = false;
  mPending = true;
  mStage = Stage::Idle;
  doneCurrent();
}

void Viewport::showEvent(QShowEvent* event) {
  QOpenGLWidget::showEvent(event);
  if (std::exchange(mHasGivenUp, false)) noteLoss();
  if (bindContext() && !mShown) resizeGL(width(), height());
  if (mRenderer) mSectionTimer.start();  // what stood still while nobody saw it
}

/// Qt makes another context for a widget that has come into another window, and does so at its word.
void Viewport::renewContext() {
  release();
  QEvent moved(QEvent::WindowChangeInternal);
  QCoreApplication::sendEvent(this, &moved);
  if (bindContext() && !mShown) resizeGL(width(), height());
}

/// @return false where there is no context, or it was lost, which is seen to
bool Viewport::bindContext() {
  if (!mContext || mIsLost) return false;
  makeCurrent();
  if (QOpenGLContext::currentContext() != context()) {
    noteLoss();  // Qt has asked the driver
    return false;
  }
  mContext->makeCurrent();
  return true;
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
    mIsLost = !mContext && isVisible();
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

void Viewport::resizeGL(int, int) {
  if (!mContext) return;
  // The old picture stands in, stretched, until the new one is there.
  glm::ivec2 size = deviceSize();
  auto old = std::move(mShown);
  mShown = std::make_unique<QOpenGLFramebufferObject>(size.x, size.y);
  if (!mShown->isValid()) return gpu::isContextLost() ? noteLoss() : failForSize();
  QSize now(size.x, size.y);
  if (old)
    QOpenGLFramebufferObject::blitFramebuffer(mShown.get(), QRect(QPoint(), now), old.get(),
                                              QRect(QPoint(), old->size()), GL_COLOR_BUFFER_BIT, GL_LINEAR);
  startAnew();
}

}  // namespace velum::gui
