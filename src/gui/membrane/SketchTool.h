#pragma once
#include <QKeyEvent>
#include <QMouseEvent>
#include <QObject>
#include <array>
#include <optional>
#include <tuple>

#include "kit/Bars.h"
#include "kit/Selection.h"
#include "velum/core/Volume.h"
#include "velum/session/document/Document.h"
#include "view/ViewGrid.h"

namespace velum::gui {

class SketchOverlay;

/// The brush with which one strokes over what the selected membrane is to keep whole, or to let its sheet through
/// ([IMC] 3.3), on any slice or on what the 3D view shows; and what can be done to strokes afterwards. Each is an undo
/// step, after which the membrane's curve is fitted anew. [ and ], or Alt and the wheel, change the radius; Esc ends.
class SketchTool : public QObject {
  Q_OBJECT
 public:
  SketchTool(session::Document& document, ViewGrid& views, Selection& selection, MessageBar& messages, QObject* parent);

  bool isActive() const { return mActive; }
  bool isAvoiding() const { return mAvoid; }
  double radiusMm() const { return mRadiusMm; }
  /// Which stroke of the membrane is marked; -1: none.
  int selected() const { return mSelected; }
  /// The stroke that is being drawn; null when none is.
  const scene::Stroke* draft() const { return mDraft ? &*mDraft : nullptr; }
  /// Of the selected membrane; null where something else is selected.
  const std::vector<scene::Stroke>* strokes() const;
  const session::Document& document() const { return mDocument; }
  /// To be called after every change of the document.
  void refresh();

 public slots:
  void start(bool avoid);
  void stop();
  /// Of the brush, and of the marked stroke.
  void setRadius(double mm);
  /// One undo step of radii ends.
  void settleRadius() { mDocument.endMerge(); }
  void select(int stroke);
  void remove(int stroke);

 signals:
  void ended();
  void radiusChanged(double mm);
  void selectedChanged(int stroke);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  using Strokes = std::vector<scene::Stroke>;
  void listen();
  bool handleKey(QKeyEvent* event);
  bool handleView(QWidget* view, QEvent* event);
  bool begin(QWidget* view, QMouseEvent* event);
  void goOn(QWidget* view, QPointF place, bool isLast);
  void finish();
  std::optional<glm::dvec3> worldAt(QWidget* view, QPointF place);
  bool isOnHandle(QPointF place) const;
  void edit(const std::string& label, const std::function<void(Strokes&)>& change, bool merge = false);
  const Histogram& whole();
  void updateOverlays();

  session::Document& mDocument;
  ViewGrid& mViews;
  Selection& mSelection;
  MessageBar& mMessages;
  std::array<SketchOverlay*, 4> mOverlays{};  ///< over the slices and the 3D view
  bool mActive = false, mAvoid = false;
  double mRadiusMm = 3.0;
  int mSelected = -1;
  std::optional<scene::Stroke> mDraft;
  QWidget* mDrawsIn = nullptr;
  std::tuple<std::uint64_t, int, int> mCounted{};  ///< data, channel and time step of mWhole
  std::uint64_t mFitted = 0;                       ///< data to whose size the brush was last made
  Histogram mWhole;
};

}  // namespace velum::gui
