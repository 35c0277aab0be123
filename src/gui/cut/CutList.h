#pragma once
#include <QListWidget>
#include <vector>

#include "scene/Cut.h"

namespace velum::gui {

/// The list of cuts: an eye that turns one on and off, its shape, its name.
class CutList : public QListWidget {
  Q_OBJECT
 public:
  explicit CutList(QWidget* parent);
  /// Shows the scene's cuts; rows whose cut has not changed are left as they are. @param selected  row that is
  /// selected; -1: none
  void setCuts(const std::vector<scene::Cut>& cuts, int selected);
  /// Id of the cut in a row; 0: none.
  int cutAt(int row) const;

 signals:
  // The user has changed a cut; `cut` is its id.
  void toggled(int cut, bool enabled);
  void renamed(int cut, const QString& name);
  /// Alt and an arrow key: the selected cut is to be moved in the list. @param by  -1: up, 1: down
  void moveAsked(int by);

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
};

}  // namespace velum::gui
