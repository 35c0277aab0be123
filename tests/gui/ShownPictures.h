#pragma once
#include <QWidget>

#include "gui/view/Viewport.h"

namespace velum::gui {

/// How many pictures a view has shown, with one that is drawn and waits to be painted.
inline int shownPictures(Viewport& viewport) {
  viewport.surface().widget().repaint();
  return viewport.shownCount();
}

}  // namespace velum::gui
