#pragma once
#include <QPainter>
#include <functional>
#include <optional>

#include "gui/tool/ViewPoint.h"

namespace velum::gui {

/// A button of the pointer that goes down, is dragged, or is let go, in a view.
struct PointerEvent {
  const ViewPoint& at;
  Qt::MouseButton button = Qt::NoButton;  ///< while it is dragged: none
  Qt::KeyboardModifiers keys;
  QPoint globalPlace;
};

/// A key that is pressed in the window.
struct KeyStroke {
  int key = 0;
  Qt::KeyboardModifiers keys;
  bool isInView = false;  ///< a view has the keyboard
  bool isTyping = false;  ///< it goes into a field
};

/// What to do about a key; empty: it is for others.
using KeyAnswer = std::function<void()>;

/// Paints over one view, in its (logical) pixels.
struct ViewPainter {
  QPainter& painter;
  ToolView& view;
  session::ViewSpace space;
  QSize size;
};

/// Something that stands over the views and can be taken hold of at any time, such as the handles of a cut. The toolbox
/// asks it before a view takes the pointer for camera or crosshair. The window's thread.
class Manipulator {
 public:
  virtual ~Manipulator() = default;

  /// A button goes down. @return true: what follows is this one's, until the last button is let go
  virtual bool press(const PointerEvent&) { return false; }
  virtual void drag(const PointerEvent&) {}
  virtual void release(const PointerEvent&) {}
  /// No button is down. @return the cursor where press() would take hold
  virtual std::optional<Qt::CursorShape> hover(const ViewPoint&) { return std::nullopt; }
  /// The pointer has left the views, or has gone on to something else.
  virtual void leave() {}
  /// A handle stands here in the way of tools that draw on what is seen.
  virtual bool isInTheWay(const ViewPoint&) const { return false; }
  /// @param notches  of the wheel, away from the hand
  virtual bool wheel(const PointerEvent&, double /*notches*/) { return false; }
  /// Asked before commands that have the same key.
  virtual KeyAnswer key(const KeyStroke&) { return {}; }
  /// The document has changed.
  virtual void refresh() {}
  virtual void paint(ViewPainter&) const {}
  /// While it is dragged the other views leave it the machine.
  virtual bool pausesOtherViews() const { return false; }
};

}  // namespace velum::gui
