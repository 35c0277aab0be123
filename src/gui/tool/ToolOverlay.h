#pragma once
#include <QWidget>

#include "gui/tool/ToolView.h"

namespace velum::gui {

class Toolbox;

/// A widget that paints what tools and manipulators show over one view, and has the view's size. It takes no events:
/// the view hands its events to the toolbox.
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
