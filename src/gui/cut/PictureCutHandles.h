#pragma once
#include "gui/service/Selection.h"
#include "gui/tool/Toolbox.h"
#include "session/cut/CutTool.h"
#include "session/document/Document.h"

namespace velum::gui {

/// The outline and the handles of the selected cut over the 3D picture.
class PictureCutHandles : public QObject, public Manipulator {
  Q_OBJECT
 public:
  PictureCutHandles(session::Document& document, Selection& selection, Toolbox& toolbox, QObject* parent);

  bool press(const PointerEvent& event) override;
  void drag(const PointerEvent& event) override;
  void release(const PointerEvent& event) override;
  std::optional<Qt::CursorShape> hover(const ViewPoint& at) override;
  void leave() override { setHover(session::CutHandle::None); }
  bool isInTheWay(const ViewPoint& at) const override { return handleUnder(at) != session::CutHandle::None; }
  void paint(ViewPainter& over) const override;

 private:
  session::CutHandle handleUnder(const ViewPoint& at) const;
  void setHover(session::CutHandle handle);

  session::Document& mDocument;
  Selection& mSelection;
  Toolbox& mToolbox;
  session::CutHandle mHover = session::CutHandle::None;
  // While a handle is dragged.
  session::CutHandle mHandle = session::CutHandle::None;
  scene::Cut mStart;
  session::CutGizmo mStartGizmo;
  glm::dvec2 mFrom{0.0};
  QPointF mPointer;
  QString mTag;  ///< Numbers beside the pointer.
};

}  // namespace velum::gui
