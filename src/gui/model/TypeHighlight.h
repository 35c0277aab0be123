#pragma once
#include <QImage>

#include "gui/tool/Manipulator.h"
#include "gui/view/Viewport.h"
#include "session/model/ModelEdit.h"

namespace velum::gui {

/// Shows where the picture shows some types, while the pointer is on their row: all else is darkened.
class TypeHighlight : public Manipulator {
 public:
  explicit TypeHighlight(Viewport& viewport) : mViewport(viewport) {}
  /// None: nothing is darkened. @return true where there is something else to be painted
  bool show(const session::TypeNumbers& types);
  /// The picture is another one.
  bool look();
  /// Pixels of the picture that show them.
  int pixels() const { return mPixels; }

  void paint(ViewPainter& over) const override;

 private:
  Viewport& mViewport;
  session::TypeNumbers mTypes;
  QImage mVeil;
  int mPixels = 0;
};

}  // namespace velum::gui
