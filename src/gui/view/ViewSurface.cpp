#include "gui/view/ViewSurface.h"

#include <QCoreApplication>
#include <QEvent>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLWidget>
#include <QPainter>
#include <utility>

#include "core/Error.h"
#include "gpu/Allocation.h"
#include "gpu/Framebuffer.h"
#include "gpu/GpuError.h"
#include "gpu/Loss.h"
#include "gpu/Texture.h"
#include "gui/kit/CoreWords.h"

namespace velum::gui {

namespace {

bool gDrawsBesideWindows = false;

constexpr const char* kPurpose = "picture of a view";

gpu::Allocation allocationOf(glm::ivec2 size) {
  return {kPurpose, std::size_t(size.x) * std::size_t(size.y) * 4, glm::ivec3(size, 1)};
}

/// Lets what lies above have the mouse and the keyboard.
void layBelow(QWidget& surface) {
  surface.setAttribute(Qt::WA_TransparentForMouseEvents);
  surface.setFocusPolicy(Qt::NoFocus);
  surface.resize(surface.parentWidget()->size());
  surface.lower();
}

/// Draws in a context of the window system, which Qt makes, and makes anew in another window.
class WindowSurface : public QOpenGLWidget, public ViewSurface {
 public:
  WindowSurface(QWidget& view, Listener listener) : QOpenGLWidget(&view), ViewSurface(std::move(listener)) {
    layBelow(*this);
  }
  ~WindowSurface() override {
    disconnect(mLeaving);  // the context ends with the widget
  }

  QWidget& widget() override { return *this; }
  bool bind() override {
    if (!mContext) return false;
    makeCurrent();
    if (QOpenGLContext::currentContext() != QOpenGLWidget::context()) return false;  // Qt has asked the driver
    mContext->makeCurrent();
    return true;
  }
  void drop() override {
    mShown.reset();
    mContext.reset();
    doneCurrent();
  }
  /// Qt makes another context for a widget that has come into another window, and does so at its word.
  void renew() override {
    QEvent moved(QEvent::WindowChangeInternal);
    QCoreApplication::sendEvent(this, &moved);
  }
  bool resize(glm::ivec2 size) override {
    auto old = std::move(mShown);
    try {
      gpu::allocate(allocationOf(size), gpu::Answer::AtOnce,
                    [&] { mShown = std::make_unique<QOpenGLFramebufferObject>(size.x, size.y); });
    } catch (const gpu::NoMemory&) {
      mShown.reset();
    }
    if (mShown && !mShown->isValid()) mShown.reset();
    if (!mShown) return false;
    if (old)
      QOpenGLFramebufferObject::blitFramebuffer(mShown.get(), QRect(QPoint(), mShown->size()), old.get(),
                                                QRect(QPoint(), old->size()), GL_COLOR_BUFFER_BIT, GL_LINEAR);
    return true;
  }
  glm::ivec2 size() const override { return mShown ? glm::ivec2(mShown->width(), mShown->height()) : glm::ivec2(0); }
  void take(render::Renderer& renderer) override {
    renderer.present(mShown->handle(), size());
    update();
  }
  QImage picture() override { return grabFramebuffer(); }

 protected:
  void initializeGL() override {
    disconnect(mLeaving);
    mLeaving = connect(
        QOpenGLWidget::context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { mListener.leaves(); },
        Qt::DirectConnection);
    try {
      mContext = gpu::Context::adopt(
          [](const char* name) {
            return reinterpret_cast<void*>(QOpenGLContext::currentContext()->getProcAddress(name));
          },
          [] { return static_cast<const void*>(QOpenGLContext::currentContext()); });
      mListener.made();
    } catch (const Error& error) {
      mContext.reset();
      mListener.failed(inWords(error.what()));
    }
  }
  void resizeGL(int, int) override {
    if (mContext) mListener.resized();
  }
  void paintGL() override {
    if (!mShown || !mListener.paints()) return;
    QRect all(QPoint(), mShown->size());
    QOpenGLFramebufferObject::blitFramebuffer(nullptr, all, mShown.get(), all);
    mListener.painted();
  }

 private:
  std::unique_ptr<QOpenGLFramebufferObject> mShown;
  QMetaObject::Connection mLeaving;
};

/// Draws in a context beside the window system; its pictures are read back.
class ImageSurface : public QWidget, public ViewSurface {
 public:
  ImageSurface(QWidget& view, Listener listener) : QWidget(&view), ViewSurface(std::move(listener)) {
    layBelow(*this);
    setAttribute(Qt::WA_OpaquePaintEvent);
  }

  QWidget& widget() override { return *this; }
  bool bind() override {
    if (!mContext) return false;
    mContext->makeCurrent();
    return true;
  }
  void drop() override {
    mTarget = {};
    mTexture = {};
    mContext.reset();
    mShown = {};
  }
  void renew() override { begin(); }
  bool resize(glm::ivec2 size) override {
    QSize wanted(size.x, size.y);
    mShown = mShown.isNull() ? QImage(wanted, QImage::Format_RGBX8888)
                             : mShown.scaled(wanted, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    if (!mHasPicture) mShown.fill(Qt::black);
    update();
    return true;
  }
  glm::ivec2 size() const override { return {mShown.width(), mShown.height()}; }
  void take(render::Renderer& renderer) override {
    // Who is asked about a frame makes a context that was lost anew.
    if (mTarget.size() != size() || mTargetContext != gpu::contextNumber()) {
      mTargetContext = gpu::contextNumber();
      mTarget = {};
      mTexture = gpu::Texture::make2d(kPurpose, gpu::Format::Rgba8, size());
      mTarget = gpu::Framebuffer(kPurpose, {&mTexture});
    }
    renderer.present(mTarget.id(), size());
    QImage bottomUp(mShown.size(), QImage::Format_RGBX8888);
    mTexture.read(bottomUp.bits(), std::size_t(bottomUp.sizeInBytes()));
    mShown = bottomUp.mirrored();
    mHasPicture = true;
    update();
  }
  QImage picture() override {
    QImage shown = mShown;
    shown.setDevicePixelRatio(devicePixelRatioF());
    return shown;
  }

 protected:
  void showEvent(QShowEvent* event) override {
    QWidget::showEvent(event);
    if (!mContext) begin();
  }
  void resizeEvent(QResizeEvent* event) override {
    QWidget::resizeEvent(event);
    if (mContext) mListener.resized();
  }
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    if (mShown.isNull()) return painter.fillRect(rect(), Qt::black);
    painter.drawImage(rect(), mShown);
    if (mListener.paints()) mListener.painted();
  }

 private:
  void begin() {
    mHasPicture = false;
    try {
      mContext = gpu::Context::create(gpu::ContextKind::Auto);
      mListener.made();
      mListener.resized();
    } catch (const Error& error) {
      mContext.reset();
      mListener.failed(inWords(error.what()));
    }
  }

  gpu::Texture mTexture;
  gpu::Framebuffer mTarget;
  unsigned mTargetContext = 0;
  QImage mShown;
  bool mHasPicture = false;
};

}  // namespace

std::unique_ptr<ViewSurface> ViewSurface::make(QWidget& view, Listener listener) {
  bool isBeside = gDrawsBesideWindows || gpu::Context::kindOfEnvironment() != gpu::ContextKind::Auto;
  if (isBeside) return std::make_unique<ImageSurface>(view, std::move(listener));
  return std::make_unique<WindowSurface>(view, std::move(listener));
}

void ViewSurface::drawBesideWindows() { gDrawsBesideWindows = true; }

}  // namespace velum::gui
