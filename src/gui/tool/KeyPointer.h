#pragma once
#include "gui/tool/Manipulator.h"

namespace velum::gui {

class Toolbox;

/// The pointer of those who use keys: while a tool is active and a view has the keyboard, arrows move a mark over the
/// view, Enter clicks there, and Space presses the button, with which the arrows then drag, and lets go of it. Shift
/// makes steps larger. It does what the mouse does, so that no tool knows the difference.
class KeyPointer {
 public:
  explicit KeyPointer(Toolbox& toolbox) : mToolbox(toolbox) {}
  /// @param view  that has the keyboard
  KeyAnswer key(const KeyStroke& stroke, ToolView& view);
  /// The tool was laid down: nothing is pressed any more.
  void letGo();
  void paint(ViewPainter& over) const;

 private:
  void move(ToolView& view, QPointF step);
  void toggle(ToolView& view);
  void press();
  void release();
  bool isIn(const ToolView& view) const { return mView == &view; }

  Toolbox& mToolbox;
  ToolView* mView = nullptr;  ///< Where the mark is; null: it was not needed yet.
  QPointF mPlace;
  bool mIsDown = false, mHasMoved = false;
};

}  // namespace velum::gui
