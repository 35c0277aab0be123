#pragma once
#include <QPainter>
#include <functional>
#include <optional>

#include "gui/tool/ViewPoint.h"

namespace velum::gui {

/// A button of the pointer that goes down, is dragged, or is let go, in a view.
struct PointerEvent {
  const ViewPoint& at;
  Qt::MouseButton button = Qt::NoButton;  ///< during a drag: none
  Qt::KeyboardModifiers keys;
  QPoint globalPlace;
};

/// A key that is pressed in the window.
struct KeyStroke {
  int key = 0;
  Qt::KeyboardModifiers keys;
  ToolView* view = nullptr;  ///< that has the keyboard; null: none has it
  bool isTyping = false;     ///< the key goes into a field of text
};

/// What to do about a key; empty: the asked object does not use the key.
using KeyAnswer = std::function<void()>;

/// Paints over one view, in its (logical) pixels.
struct ViewPainter {
  QPainter& painter;
  ToolView& view;
  session::ViewSpace space;
  QSize size;
};

/// Something that stands over the views and can be taken hold of at any time, such as the handles of a cut. The toolbox
/// hands it an event before a view uses the pointer for camera or crosshair. All functions are called in the window's
/// thread.
class Manipulator {
 public:
  virtual ~Manipulator() = default;

  /// A button goes down. @return true: this manipulator gets all that follows, until the last button is let go
  virtual bool press(const PointerEvent&) { return false; }
  virtual void drag(const PointerEvent&) {}
  virtual void release(const PointerEvent&) {}
  /// The pointer moves with no button down. @return the cursor where press() would take hold
  virtual std::optional<Qt::CursorShape> hover(const ViewPoint&) { return std::nullopt; }
  /// The pointer has left the views, or has gone on to something else.
  virtual void leave() {}
  /// A handle stands here in the way of tools that draw on what is seen.
  virtual bool isInTheWay(const ViewPoint&) const { return false; }
  /// @param notches  of the wheel, away from the hand
  virtual bool wheel(const PointerEvent&, double /*notches*/) { return false; }
  /// Called before commands of the window that have the same key.
  virtual KeyAnswer key(const KeyStroke&) { return {}; }
  /// The document has changed.
  virtual void refresh() {}
  virtual void paint(ViewPainter&) const {}
  /// What is painted belongs to the picture: it stays where handles are put away.
  virtual bool isOfPicture() const { return false; }
  /// True while a drag needs the machine for its own view: the other views pause.
  virtual bool pausesOtherViews() const { return false; }
};

}  // namespace velum::gui
