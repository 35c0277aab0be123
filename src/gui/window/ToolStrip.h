#pragma once
#include <QToolBar>

#include "gui/service/ActionTable.h"

namespace velum::gui {

/// The tool bar: what the program is for comes first. All of it is icons; as many as there is room for say their name,
/// too, in the same order, and what a narrow window has no room for at all is behind a button at the end.
class ToolStrip : public QToolBar {
  Q_OBJECT
 public:
  explicit ToolStrip(QWidget* window);
  /// Once all commands are there.
  void fill(const ActionTable& actions);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void nameWhatFits();
};

}  // namespace velum::gui
