#pragma once
#include <QObject>
#include <functional>
#include <optional>

#include "gui/membrane/SheetHandsPaint.h"
#include "gui/service/Selection.h"
#include "gui/tool/Toolbox.h"
#include "session/document/Document.h"

namespace velum::gui {

/// Pins and kernels of the selected membrane in all views: they can be selected, dragged, resized and removed at any
/// time, whatever tool is active.
class SheetGrips : public QObject, public Manipulator {
  Q_OBJECT
 public:
  /// What a drag does.
  enum class Drag { None, Hand, Radius, Menu };

  SheetGrips(session::Document& document, Selection& selection, Toolbox& toolbox, QObject* parent);

  session::Hand selected() const { return mSelected; }
  /// Takes hold of a pin or kernel that a tool has just put in. @param label  of the undo step that the tool has begun
  void begin(const PointerEvent& event, session::Hand hand, Drag drag, const char* label);

  /// The drag is over: one undo step.
  void letGo();

  bool press(const PointerEvent& event) override;
  void drag(const PointerEvent& event) override;
  void release(const PointerEvent& event) override;
  std::optional<Qt::CursorShape> hover(const ViewPoint& at) override;
  void leave() override { setHover({}); }
  KeyAnswer key(const KeyStroke& stroke) override;
  void refresh() override;
  void paint(ViewPainter& over) const override;

 public slots:
  void select(velum::session::Hand hand);
  void removeSelected();
  void turnSelected();

 signals:
  void selectedChanged(velum::session::Hand hand);

 private:
  void setHover(session::Hand hand);
  void showMenu(QPoint globalPlace);
  session::Hand handUnder(const ViewPoint& at) const;

  session::Document& mDocument;
  Selection& mSelection;
  Toolbox& mToolbox;
  session::Hand mSelected, mHover;
  // While a pin or kernel is dragged.
  Drag mDrag = Drag::None;
  const char* mLabel = "";
  const ToolView* mView = nullptr;
  session::ViewSpace mStartSpace;
  scene::Membrane mStart;
  glm::dvec2 mFrom{0.0};
  QPointF mPointer;
  QString mTag;  ///< The number beside the pointer.
};

}  // namespace velum::gui
