#pragma once
#include <QAbstractScrollArea>
#include <QMenu>
#include <map>
#include <optional>

#include "gui/timeline/KeyEdit.h"
#include "gui/timeline/TimeScale.h"
#include "session/document/Document.h"

namespace velum::gui {

/// The tracks of a film over time: a ruler with the range and the playhead, and a row for each track with its keys. The
/// playhead is dragged over the ruler; keys are selected, dragged, copied, eased and removed. Each change is one undo
/// step.
class TrackCanvas : public QAbstractScrollArea {
  Q_OBJECT
 public:
  TrackCanvas(session::Document& document, QWidget* parent);

  /// To be called after every change of the document.
  void refresh();
  void setSnapping(bool snaps) { mSnaps = snaps; }
  /// Shows more or less time; fit() shows all of the film, and goes on to.
  void zoom(double factor);
  void fit();
  /// Moves the playhead when the window comes back to its events: of many places only the last is shown.
  void scrubTo(double time);
  /// Puts the playhead on the next key of any track, or of the selected ones, after it (1) or before it (-1).
  void goToKey(int direction);
  /// Makes a key of the selected row at the playhead.
  void keyRow();
  void removeSelected();

  const KeyNames& selected() const { return mSelected; }
  /// Where a key is, in pixels of viewport(); nothing for one that is not there.
  std::optional<QPointF> placeOf(const KeyName& key) const;
  /// Where a time is on the ruler, in pixels of viewport().
  QPointF onRuler(double time) const;
  /// The middle of a track's title, and its eye, in pixels of viewport().
  QPointF onTitle(std::size_t row) const;
  QPointF onEye(std::size_t row) const;
  QSize sizeHint() const override { return {600, 140}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  bool event(QEvent* event) override;
  bool viewportEvent(QEvent* event) override;
  bool focusNextPrevChild(bool next) override;

 private:
  enum class Drag { None, Playhead, RangeStart, RangeEnd, Keys, Band, Pan };
  /// What is under the pointer.
  struct Hit {
    enum class Part { Nothing, Ruler, RangeStart, RangeEnd, Eye, Title, Row, Key } part = Part::Nothing;
    std::size_t row = 0;
    KeyName key;
  };

  const scene::Timeline& timeline() const { return mDocument.scene().timeline; }
  const Tracks& tracks() const { return timeline().tracks; }
  Hit hitAt(QPointF place) const;
  QRectF timeArea() const;
  double yOf(std::size_t row) const;
  double playhead() const { return mDocument.playhead().value_or(0.0); }
  double rangeEnd() const;
  /// A time as it is taken where snapping is on: a frame, or what is near: the playhead, keys.
  double snapped(double time, const KeyNames& but = {}) const;
  void fitNow();
  void placeBars();
  void pan(double pixels);
  void showTime(double time);

  void pressKey(const KeyName& key, Qt::KeyboardModifiers keys);
  void dragKeys(QPointF place, bool copies);
  void dragRange(double time);
  void dragBand(QPointF place, bool adds);
  void moveSelected(double seconds);
  void select(KeyNames keys);
  void selectRow(std::size_t row);
  bool isSelected(const KeyName& key) const;
  KeyNames allKeys() const;
  void change(const QString& step, const Tracks& tracks, bool merge = false);
  void toggle(std::size_t row);
  void paste();
  void fillKeyMenu(QMenu& menu);
  void fillRowMenu(QMenu& menu, std::size_t row);
  QString tipOf(const Hit& hit) const;
  bool isOwnKey(const QKeyEvent& event) const;

  void paintRuler(QPainter& painter) const;
  void paintRange(QPainter& painter) const;
  void paintFlags(QPainter& painter) const;
  void paintTitle(QPainter& painter, std::size_t row) const;
  void paintTrack(QPainter& painter, std::size_t row);
  void paintWay(QPainter& painter, const scene::Track& track, double y);
  void paintPlayhead(QPainter& painter) const;
  const std::vector<double>& curveOf(const scene::Track& track);

  session::Document& mDocument;
  TimeScale mScale;
  bool mIsFitted = true, mSnaps = true;
  KeyNames mSelected;
  std::string mRow;  ///< the path of the selected track
  std::vector<KeyClip> mClips;
  std::optional<double> mWanted;  ///< where the playhead is to go
  double mFollowed = 0.0;         ///< where the playhead was at the last refresh
  std::optional<KeyName> mHover;
  // While something is dragged.
  Drag mDrag = Drag::None;
  bool mHasMoved = false;
  QPointF mPressed, mLast;
  KeyName mGrabbed;
  Tracks mStart;
  KeyNames mStartSelected;
  QRectF mBand;
  /// What a number is over the film, from 0 to 1 of its row, by the track's path; made anew where the track is another.
  struct Curve {
    scene::Track track;
    double duration = 0.0;
    std::vector<double> heights;
  };
  std::map<std::string, Curve> mCurves;
};

}  // namespace velum::gui
