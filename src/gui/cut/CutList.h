#pragma once
#include <vector>

#include "gui/rows/EyeList.h"
#include "scene/Cut.h"

namespace velum::gui {

/// The list of cuts: an eye that turns one on and off, its shape, its name.
class CutList : public EyeList {
  Q_OBJECT
 public:
  explicit CutList(QWidget* parent);
  /// Shows the scene's cuts. @param selected  row that is selected; -1: none
  void setCuts(const std::vector<scene::Cut>& cuts, int selected);

 signals:
  /// Alt and an arrow key: the selected cut is to be moved in the list. @param by  -1: up, 1: down
  void moveAsked(int by);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
};

}  // namespace velum::gui
