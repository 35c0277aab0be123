#pragma once
#include "gui/tool/Manipulator.h"

namespace velum::gui {

class Toolbox;

/// The pointer of those who use keys: while a tool is active and a view has the keyboard, arrows move a mark over the
/// view, Enter clicks there, and Space presses the left button or lets go of it; while the button is down the arrows
/// drag. Shift makes steps larger. Tools get the same events as from the mouse, and need not know the difference.
class KeyPointer {
 public:
  explicit KeyPointer(Toolbox& toolbox) : mToolbox(toolbox) {}
  /// @param view  the view that has the keyboard
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
  ToolView* mView = nullptr;  ///< The view that the mark is in; null: no mark was needed yet.
  QPointF mPlace;
  bool mIsDown = false, mHasMoved = false;
};

}  // namespace velum::gui
