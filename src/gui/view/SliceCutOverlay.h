#pragma once
#include <QPainter>
#include <QPointF>
#include <QString>
#include <map>

#include "kit/Selection.h"
#include "velum/render/section/SliceImage.h"
#include "velum/session/cut/SliceCutTool.h"
#include "velum/session/document/Document.h"
#include "velum/session/membrane/SheetHands.h"

namespace velum::gui {

/// The cuts on a slice: their lines, and the handles of the selected one. A slice view calls
/// paint() last in its paintEvent, and press(), move() and release() first in its mouse events, with the frame that it
/// draws by; where they answer true the event was for the cut.
class SliceCutOverlay {
 public:
  SliceCutOverlay(session::Document& document, Selection& selection);

  /// The sheets of the enabled membranes as they stand now.
  void setSheets(const render::SheetIndices& sheets);

  void paint(QPainter& painter, const scene::SliceFrame& frame) const;
  /// Takes hold of a handle, or selects the cut whose line was clicked.
  bool press(QPointF place, const scene::SliceFrame& frame);
  /// While the button is down: drags. Else: finds what is under the pointer.
  /// @param snap  Shift is held: whole voxels, 15 degrees
  bool move(QPointF place, const scene::SliceFrame& frame, bool snap);
  bool release();
  void leave();
  /// For the view to show while move() answers true.
  Qt::CursorShape cursor() const;
  bool isDragging() const { return mDragging; }

 private:
  const scene::Cut* selected() const;
  const scene::SheetShape& shapeOf(const scene::Cut& cut) const;
  void paintCut(QPainter& painter, const scene::SliceFrame& frame, const scene::Cut& cut, bool isSelected) const;
  void paintHandles(QPainter& painter, const scene::SliceFrame& frame, const scene::Cut& cut) const;

  session::Document& mDocument;
  Selection& mSelection;
  std::map<int, scene::SheetShape> mSheets;  ///< by the id of the cut
  session::SliceHandle mHandle;
  bool mDragging = false;
  scene::Cut mStart;
  scene::SliceFrame mStartFrame;
  glm::dvec2 mFrom{0.0};
  QPointF mPointer;
  QString mTag;
};

}  // namespace velum::gui
