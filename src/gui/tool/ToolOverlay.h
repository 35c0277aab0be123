#pragma once
#include <QWidget>

#include "gui/tool/ToolView.h"

namespace velum::gui {

class Toolbox;

/// What tools and manipulators show over one view, whose size it follows. Takes no events: the view hands them over.
class ToolOverlay : public QWidget {
 public:
  ToolOverlay(const Toolbox& toolbox, ToolView& view);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  const Toolbox& mToolbox;
  ToolView& mView;
};

}  // namespace velum::gui
