#pragma once
#include <QListWidget>
#include <vector>

#include "velum/scene/Cut.h"

namespace velum::gui {

/// The list of cuts: an eye that turns one on and off, its shape, its name.
class CutList : public QListWidget {
  Q_OBJECT
 public:
  explicit CutList(QWidget* parent);
  /// Takes the scene's cuts over; does nothing to rows that are the same.
  void setCuts(const std::vector<scene::Cut>& cuts, int selected);

 signals:
  void toggled(int row, bool enabled);
  void renamed(int row, const QString& name);
  /// Alt and an arrow key. @param by  -1: up, 1: down
  void moveAsked(int by);

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
};

/// What a cut is called in lists and messages. @param index  its place, from 0
QString cutTitle(const scene::Cut& cut, int index);

}  // namespace velum::gui
