#pragma once
#include <QObject>
#include <optional>

#include "gui/service/Selection.h"
#include "gui/tool/Toolbox.h"
#include "gui/view/LetteringOverlay.h"
#include "session/document/Document.h"
#include "session/mark/MarkHands.h"

namespace velum::gui {

class MarkTool;

/// Marks over all views: a press selects one; its points and its words are dragged at any time, whatever tool is
/// active. With the keyboard Tab goes from point to point of the selected mark and arrows move that point.
class MarkGrips : public QObject, public Manipulator {
  Q_OBJECT
 public:
  MarkGrips(session::Document& document, Selection& selection, Toolbox& toolbox, const LetteringOverlay& lettering,
            QObject* parent);

  /// A point or the words of a mark are within reach.
  bool holds(const ViewPoint& at) const;

  bool press(const PointerEvent& event) override;
  void drag(const PointerEvent& event) override;
  void release(const PointerEvent& event) override;
  std::optional<Qt::CursorShape> hover(const ViewPoint& at) override;
  void leave() override { setHover({}); }
  bool isInTheWay(const ViewPoint& at) const override { return holds(at); }
  KeyAnswer key(const KeyStroke& stroke) override;
  void refresh() override;
  void paint(ViewPainter& over) const override;

 signals:
  /// The right button was clicked on a mark, which is selected now.
  void menuAsked(int mark, QPoint globalPlace);
  void removeAsked(int mark);

 private:
  const scene::Mark* selected() const { return session::findMark(mDocument.shown(), mSelection.mark()); }
  session::MarkGrip gripUnder(const ViewPoint& at) const;
  /// The words under the pointer that belong to a mark, or, of the mark 0, those of a name that is none.
  const session::PlacedWords* wordsUnder(const ViewPoint& at, int mark) const;
  void takeName(const session::PlacedWords& name);
  const MarkTool* tool() const;
  bool isSetting() const;
  void setHover(session::MarkGrip grip);
  void choosePoint(int point);
  void place(const scene::Mark& mark, const char* step);
  void step(ToolView& view, QPointF way);

  session::Document& mDocument;
  Selection& mSelection;
  Toolbox& mToolbox;
  const LetteringOverlay& mLettering;
  session::MarkGrip mHover;
  int mPoint = -1;  ///< of the selected mark, which the arrow keys move; -1: none
  // While something is dragged.
  session::MarkGrip mHeld;
  scene::Mark mStart;
  session::PlacedWords mWords;  ///< that are dragged, where they stood
  session::ViewSpace mStartSpace;
  glm::dvec2 mFrom{0.0};
  const ToolView* mView = nullptr;
  QPointF mPointer;
  bool mWantsMenu = false, mHasMoved = false;
};

}  // namespace velum::gui
