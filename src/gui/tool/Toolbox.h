#pragma once
#include <QAbstractButton>
#include <QAction>
#include <QMouseEvent>
#include <QObject>
#include <QWheelEvent>
#include <vector>

#include "gui/tool/KeyPointer.h"
#include "gui/tool/Tool.h"
#include "session/document/Document.h"

namespace velum::gui {

class ToolOverlay;

/// Who has the pointer in the views: first the tool that is active, then the manipulators that stand over the views,
/// what was added last first, then the view itself, which moves camera or crosshair. At most one tool is
/// active; Esc lays it down. Views hand it their events; it knows what is dragged until the last button is let go.
class Toolbox : public QObject {
  Q_OBJECT
 public:
  /// @param window  whose keys it hears
  Toolbox(const session::Document& document, QWidget& window);

  /// Paints over a view from now on. The view hands its events over by the functions below.
  void addView(ToolView& view);
  /// Is asked before those that were added before it, and painted over them.
  void add(Manipulator& manipulator) { mManipulators.insert(mManipulators.begin(), &manipulator); }
  /// The button, or the command, is down while the tool is active, and takes it up or lays it down.
  void bind(Tool& tool, QAbstractButton& button);
  void bind(Tool& tool, QAction& action);

  Tool* active() const { return mActive; }
  /// Lays down the tool that is active and takes up this one; none is active when it refuses.
  void start(Tool& tool);
  /// Lays down the tool that is active, or this one if it is.
  void stop();
  void stop(const Tool& tool);

  /// Manipulators are shown over the views and can be taken hold of; put away, they leave the picture and their keys.
  bool handlesShown() const { return mHandlesShown; }
  void setHandlesShown(bool shown);

  // From views. True: the event was not for the view.
  bool press(ToolView& view, const QMouseEvent& event);
  bool drag(ToolView& view, const QMouseEvent& event);
  bool release(ToolView& view, const QMouseEvent& event);
  /// A click that took hold of nothing.
  bool click(ToolView& view, const QMouseEvent& event);
  bool wheel(ToolView& view, const QWheelEvent& event);
  /// The pointer moves with no button down. @return the cursor where something would take the next press
  std::optional<Qt::CursorShape> hover(ToolView& view, QPointF place);
  void leave();

  // From the keyboard, for the active tool alone: the left button at a place of a view.
  void pressAt(ToolView& view, QPointF place);
  void dragAt(ToolView& view, QPointF place);
  /// @param isClick  it did not move meanwhile
  void releaseAt(ToolView& view, QPointF place, bool isClick);
  void hoverAt(ToolView& view, QPointF place);

  /// What is dragged wants the machine for its view.
  bool pausesOtherViews() const { return mHolder && mHolder->pausesOtherViews(); }
  /// Something stands here that tools which draw are to leave alone.
  bool isInTheWay(const ViewPoint& at) const;
  /// To be called after every change of the document.
  void refresh();
  /// Paints over all views anew, or over one.
  void repaint();
  void repaint(const ToolView& view);
  void paint(ViewPainter& over) const;

 signals:
  /// Another tool is active, or none.
  void activeChanged(velum::gui::Tool* active);
  void handlesShownChanged(bool shown);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Place {
    ToolView* view;
    ToolOverlay* overlay;
  };
  bool hasHandles(const ToolView& view) const;
  std::vector<Manipulator*> chainOf(const ToolView& view) const;
  KeyAnswer answerTo(const KeyStroke& stroke);
  ToolView* viewWithKeyboard(const QObject* watched) const;
  void showCursors();
  bool isOurs(const QObject* watched) const;

  const session::Document& mDocument;
  QWidget& mWindow;
  std::vector<Place> mViews;
  std::vector<Manipulator*> mManipulators;
  bool mHandlesShown = true;
  Tool* mActive = nullptr;
  Manipulator* mHolder = nullptr;  ///< Has taken hold of the pointer.
  KeyPointer mKeyPointer{*this};
};

}  // namespace velum::gui
