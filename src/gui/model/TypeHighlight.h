#pragma once
#include <QImage>

#include "gui/tool/Manipulator.h"
#include "gui/view/Viewport.h"
#include "session/model/ModelEdit.h"

namespace velum::gui {

/// Shows where in the picture some types are, while the pointer is on their row: all other pixels are darkened.
class TypeHighlight : public Manipulator {
 public:
  explicit TypeHighlight(Viewport& viewport) : mViewport(viewport) {}
  /// Sets the types; none: nothing is darkened. @return true when the views must be painted anew
  bool show(const session::TypeNumbers& types);
  /// To be called when the picture begins to change: what is darkened belongs to the picture before, and nothing is
  /// until look(). @return as show()
  bool takeAway();
  /// To be called when the picture is another one, and complete. @return as show()
  bool look();
  /// Something is darkened.
  bool isSeen() const { return !mVeil.isNull(); }
  /// How many pixels of the picture show the types.
  int pixels() const { return mPixels; }

  void paint(ViewPainter& over) const override;

 private:
  Viewport& mViewport;
  bool mIsStill = true;  ///< the picture is complete
  session::TypeNumbers mTypes;
  QImage mVeil;
  int mPixels = 0;
};

}  // namespace velum::gui
