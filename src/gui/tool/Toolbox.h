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
/// the one that was added last first, then the view itself, which moves camera or crosshair. At most one tool is
/// active; Esc lays it down. Views hand their events to the toolbox; it keeps in mind which tool or manipulator is
/// dragged until the last button is let go.
class Toolbox : public QObject {
  Q_OBJECT
 public:
  /// @param window  the window whose keys the toolbox hears
  Toolbox(const session::Document& document, QWidget& window);

  /// Paints over a view from now on. The view hands its events over by the functions below.
  void addView(ToolView& view);
  /// Adds a manipulator, which is asked before those that were added earlier, and painted over them.
  void add(Manipulator& manipulator) { mManipulators.insert(mManipulators.begin(), &manipulator); }
  /// Ties a button, or a command, to a tool: it is down while the tool is active, and a press takes the tool up or lays
  /// it down.
  void bind(Tool& tool, QAbstractButton& button);
  void bind(Tool& tool, QAction& action);

  Tool* active() const { return mActive; }
  /// Lays down the tool that is active and takes up this one; when this one refuses to start, no tool is active.
  void start(Tool& tool);
  /// Lays down the tool that is active; with an argument only if that tool is the active one.
  void stop();
  void stop(const Tool& tool);

  /// Whether manipulators are shown over the views and can be taken hold of; while they are put away they also get no
  /// keys.
  bool handlesShown() const { return mHandlesShown; }
  void setHandlesShown(bool shown);

  // Called by views with their events. True: a tool or manipulator has used the event, and the view must not.
  bool press(ToolView& view, const QMouseEvent& event);
  bool drag(ToolView& view, const QMouseEvent& event);
  bool release(ToolView& view, const QMouseEvent& event);
  /// A click that took hold of nothing.
  bool click(ToolView& view, const QMouseEvent& event);
  bool wheel(ToolView& view, const QWheelEvent& event);
  /// The pointer moves with no button down. @return the cursor where something would take the next press
  std::optional<Qt::CursorShape> hover(ToolView& view, QPointF place);
  void leave();

  // Called by KeyPointer, for the active tool alone: the left button at a place of a view.
  void pressAt(ToolView& view, QPointF place);
  void dragAt(ToolView& view, QPointF place);
  /// @param isClick  the pointer did not move while the button was down
  void releaseAt(ToolView& view, QPointF place, bool isClick);
  void hoverAt(ToolView& view, QPointF place);

  /// The tool or manipulator that is dragged needs the machine for its own view.
  bool pausesOtherViews() const { return mHolder && mHolder->pausesOtherViews(); }
  /// A handle stands at this place, so that a tool must not draw there.
  bool isInTheWay(const ViewPoint& at) const;
  /// To be called after every change of the document.
  void refresh();
  /// Paints anew what lies over all views, or over one view.
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
  Manipulator* mHolder = nullptr;  ///< The tool or manipulator that has taken hold of the pointer; null: none.
  KeyPointer mKeyPointer{*this};
};

}  // namespace velum::gui
