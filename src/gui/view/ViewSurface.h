#pragma once
#include <QImage>
#include <QWidget>
#include <functional>
#include <glm/glm.hpp>
#include <memory>

#include "gpu/Context.h"
#include "render/Renderer.h"

namespace velum::gui {

/// Where the 3D view draws: a context, and the widget on which the newest picture stands while the next one is made.
/// Two kinds: the window system's own OpenGL draws straight to the screen; where that is missing or too old, a context
/// beside the window system draws, and the picture is read back. The window's thread.
class ViewSurface {
 public:
  /// What a surface tells the view.
  struct Listener {
    std::function<void()> made;    ///< There is a context, and it is current: the first one, or another one.
    std::function<void()> leaves;  ///< The context is about to go; what is in it is to be given back, see drop().
    std::function<void(const QString&)> failed;  ///< There is none. In words.
    std::function<void()> resized;               ///< The widget has another size, and there is a context.
    std::function<bool()> paints;                ///< The picture is about to be painted. @return false: it cannot be
    std::function<void()> painted;
  };
  /// @param view  that the surface covers, below whatever else lies on it
  static std::unique_ptr<ViewSurface> make(QWidget& view, Listener listener);
  /// From now on surfaces draw beside the window system, as they do where VELUM_CONTEXT names a kind of context.
  static void drawBesideWindows();

  virtual ~ViewSurface() = default;
  virtual QWidget& widget() = 0;
  /// Null: there is none yet, or none any more.
  gpu::Context* context() const { return mContext.get(); }
  /// Makes the context current. @return false where there is none, or the window system says that it was lost
  virtual bool bind() = 0;
  /// After a loss: the context is no more, so that what was in it is gone with it.
  void forget() { mContext.reset(); }
  /// Ends the work in the context; the picture goes, too.
  virtual void drop() = 0;
  /// Gets another context, after drop().
  virtual void renew() = 0;
  /// Gives the picture that stands a size in device pixels; it is stretched until there is another one. The context is
  /// current. @return false where the driver has no memory for it; then no picture stands
  virtual bool resize(glm::ivec2 size) = 0;
  /// Of the picture that stands, device pixels; 0: there is none.
  virtual glm::ivec2 size() const = 0;
  /// What a renderer of the context has drawn is the picture from now on. The context is current. @throw gpu::NoMemory
  virtual void take(render::Renderer& renderer) = 0;
  /// The picture that stands.
  virtual QImage picture() = 0;

 protected:
  explicit ViewSurface(Listener listener) : mListener(std::move(listener)) {}
  Listener mListener;
  std::unique_ptr<gpu::Context> mContext;
};

}  // namespace velum::gui
