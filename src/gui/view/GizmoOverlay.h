#pragma once
#include <QWidget>

#include "velum/session/cut/CutTool.h"
#include "velum/session/document/Document.h"

namespace velum::gui {

/// Draws the outline and the handles of the selected cut over the 3D view. Takes no events: the view does.
class GizmoOverlay : public QWidget {
 public:
  GizmoOverlay(const session::Document& document, QWidget* parent);
  /// @param id  of the cut; 0: none
  void showCut(int id);
  /// @return true when it was another one
  bool setHover(session::CutHandle handle);
  /// Numbers beside the pointer while something is dragged; empty: none.
  void setTag(QPointF pointer, const QString& text);
  /// The cursor that says how a handle goes.
  static Qt::CursorShape cursorFor(const session::CutGizmo& gizmo, session::CutHandle handle,
                                   const scene::Camera& camera, glm::dvec2 size);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintGizmo(QPainter& painter, const scene::Cut& cut);

  const session::Document& mDocument;
  int mCut = 0;
  session::CutHandle mHover = session::CutHandle::None;
  QPointF mPointer;
  QString mTag;
};

}  // namespace velum::gui
