#pragma once
#include <QWidget>

#include "velum/session/CutTool.h"
#include "velum/session/Document.h"

namespace velum::gui {

/// Draws the outline and the handles of the selected cut over the 3D view. Takes no events: the view does.
class GizmoOverlay : public QWidget {
 public:
  GizmoOverlay(const session::Document& document, QWidget* parent);
  void showCut(int index);
  void setHover(session::CutHandle handle);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const session::Document& mDocument;
  int mCut = -1;
  session::CutHandle mHover = session::CutHandle::None;
};

}  // namespace velum::gui
