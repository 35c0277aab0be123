#pragma once
#include <QObject>
#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "SheetHandsPaint.h"
#include "kit/Bars.h"
#include "kit/Selection.h"
#include "velum/session/document/Document.h"
#include "view/ViewGrid.h"

namespace velum::gui {

class SheetHandsOverlay;

/// Pins and kernels of the selected membrane in all views: sets them while its tool is on, and takes hold of those that
/// are there at any time. Sees the views' events before they do, and leaves them what is not for it.
class SheetTool : public QObject {
  Q_OBJECT
 public:
  enum class Mode { None, Pin, Push, Pull };

  SheetTool(session::Document& document, ViewGrid& views, Selection& selection, MessageBar& messages, QObject* parent);

  Mode mode() const { return mMode; }
  session::Hand selected() const { return mSelected; }
  /// To be called after every change of the document.
  void refresh();
  /// The membrane whose hands these are; nullptr when none is selected.
  const scene::Cut* membrane() const;
  HandMarks marks() const { return {mSelected, mHover}; }
  /// Number beside the pointer, in one of the views.
  QString tagFor(const QWidget* view) const { return view == mView ? mTag : QString(); }
  QPointF pointer() const { return mPointer; }

 public slots:
  /// The next press in a view sets one; with Shift the tool stays. Selects a membrane where none is selected.
  void start(velum::gui::SheetTool::Mode mode);
  void stop();
  void select(velum::session::Hand hand);
  void removeSelected();
  void turnSelected();

 signals:
  void modeChanged(velum::gui::SheetTool::Mode mode);
  void selectedChanged(velum::session::Hand hand);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool isView(const QObject* object) const;
  bool takesKey(QObject* watched, QEvent* event);
  bool press(QWidget* view, QMouseEvent* event);
  bool move(QWidget* view, QMouseEvent* event);
  bool release(QMouseEvent* event);
  bool set(QWidget* view, glm::dvec2 place);
  void drag(glm::dvec2 place, Qt::KeyboardModifiers keys);
  void hover(QWidget* view, session::Hand hand);
  void showMenu(QPoint globalPlace);
  void edit(const char* label, const std::function<void(scene::Membrane&)>& change, bool merge);
  session::Hand handUnder(const QWidget* view, glm::dvec2 place) const;
  std::optional<session::SheetPoint> sheetUnder(const QWidget* view, glm::dvec2 place) const;
  std::optional<glm::dvec3> placeUnder(QWidget* view, glm::dvec2 place) const;
  const SliceView* sliceOf(const QWidget* view) const;

  session::Document& mDocument;
  ViewGrid& mViews;
  Selection& mSelection;
  MessageBar& mMessages;
  std::vector<SheetHandsOverlay*> mOverlays;
  Mode mMode = Mode::None;
  session::Hand mSelected, mHover;
  // While something is dragged.
  enum class Drag { None, Hand, Radius, Menu };
  Drag mDrag = Drag::None;
  const char* mLabel = "";
  QWidget* mView = nullptr;
  scene::Membrane mStart;
  scene::Camera mStartCamera;
  scene::SliceFrame mStartFrame;
  glm::dvec2 mFrom{0.0};
  QPointF mPointer;
  QString mTag;
};

}  // namespace velum::gui
