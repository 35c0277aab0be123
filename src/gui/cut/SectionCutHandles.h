#pragma once
#include <map>

#include "gui/service/Selection.h"
#include "gui/tool/Toolbox.h"
#include "render/SheetIndices.h"
#include "session/cut/SectionCutTool.h"
#include "session/document/Document.h"

namespace velum::gui {

/// The cuts on sections: their lines, by which cuts are selected and moved, and the handles of the selected cut.
class SectionCutHandles : public QObject, public Manipulator {
  Q_OBJECT
 public:
  SectionCutHandles(session::Document& document, Selection& selection, Toolbox& toolbox, QObject* parent);

  /// The sheets of the enabled membranes as they stand now.
  void setSheets(const render::SheetIndices& sheets);

  /// Takes hold of a handle, or selects the cut whose line was clicked.
  bool press(const PointerEvent& event) override;
  void drag(const PointerEvent& event) override;
  void release(const PointerEvent& event) override;
  std::optional<Qt::CursorShape> hover(const ViewPoint& at) override;
  void leave() override;
  void paint(ViewPainter& over) const override;
  bool pausesOtherViews() const override { return true; }

 private:
  const scene::SheetShape& shapeOf(const scene::Cut& cut) const;
  void paintCut(QPainter& painter, const scene::SectionPlane& plane, const scene::Cut& cut, bool isSelected) const;
  void paintHandles(ViewPainter& over, const scene::Cut& cut) const;
  Qt::CursorShape cursor() const;

  session::Document& mDocument;
  Selection& mSelection;
  Toolbox& mToolbox;
  std::map<int, scene::SheetShape> mSheets;  ///< By the id of the cut.
  session::SectionHandle mHandle;
  const ToolView* mView = nullptr;  ///< The view in which mHandle is.
  bool mDragging = false;
  scene::Cut mStart;
  scene::SectionPlane mStartFrame;
  glm::dvec2 mFrom{0.0};
  QPointF mPointer;
  QString mTag;
};

}  // namespace velum::gui
