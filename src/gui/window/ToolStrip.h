#pragma once
#include <QToolBar>

#include "gui/service/ActionTable.h"

namespace velum::gui {

/// The tool bar: the commands that the program is for come first. All commands are icons; as many as there is room for
/// show their name, too, from the first on, and commands that a narrow window has no room for are behind a button at
/// the end.
class ToolStrip : public QToolBar {
  Q_OBJECT
 public:
  explicit ToolStrip(QWidget* window);
  /// Fills the bar; to be called once all commands are in the table.
  void fill(const ActionTable& actions);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void nameWhatFits();
};

}  // namespace velum::gui
