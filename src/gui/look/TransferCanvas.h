#pragma once
#include <optional>

#include "gui/kit/CurveCanvas.h"

namespace velum::gui {

/// The picture of a transfer function over a histogram, and the hand on it: points of the opacity curve, stops in the
/// colour bar, the value axis. It changes nothing itself: it says what the function would become.
class TransferCanvas : public CurveCanvas {
  Q_OBJECT
 public:
  /// Values: opacity and colour by value. Gradients: the factor by gradient length alone, lower and without colours.
  enum class Kind { Values, Gradients };
  struct Selection {
    enum class Part { None, Point, Stop };
    Part part = Part::None;
    int index = -1;
    bool operator==(const Selection&) const = default;
  };
  TransferCanvas(Kind kind, QWidget* parent);

  void setTransfer(const scene::TransferFunction& transfer);
  const scene::TransferFunction& transfer() const { return mTransfer; }
  /// All that the axis can show.
  void setWhole(session::AxisView whole);
  /// What the axis shows; until then all.
  void setView(session::AxisView view);
  void setLogarithmic(bool logarithmic);
  /// A thin line at the value under the pointer of another view; nothing takes it away.
  void setProbe(std::optional<double> value);

  void select(Selection selection);
  Selection selection() const { return mSelection; }
  void removeSelected() override;
  /// Sets the selected point's or stop's value, and the point's opacity.
  void moveSelected(double value, double opacity);
  void colorSelected(glm::vec3 color);

  /// Where things are, widget pixels; for tests.
  session::CurveFrame frame() const;
  QRectF barRect() const;
  QRectF axisRect() const { return axis(); }

 signals:
  /// The user makes this of it. @param merge  part of a drag, which ends with settled()
  void edited(const QString& label, const velum::scene::TransferFunction& next, bool merge);
  void selectionChanged();
  /// A stop wants another colour: it was double clicked.
  void colorWanted();
  /// The axis was moved or zoomed by hand.
  void viewChanged();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  bool isOwnKey(int key) const override;
  void step(int sideways, int up, bool wide) override;
  void selectNext(int by) override;
  void addBeside() override;

 private:
  /// Line: pressed on the curve; becomes Whole when it moves, a new point when it does not.
  enum class Drag { None, Point, Stop, Line, Area, Shift, Scale, Stretch, Axis };

  session::Curve& curveOf(scene::TransferFunction& transfer) const;
  const session::Curve& curve() const { return curveOf(const_cast<scene::TransferFunction&>(mTransfer)); }
  bool hasColors() const { return mKind == Kind::Values; }
  QString named(const char* what) const;
  int stopAt(QPointF place) const;
  session::CurveHit hitAt(QPointF place) const;
  void beginDrag(QPointF place, Qt::KeyboardModifiers keys);
  void pressColors(QPointF place);
  void dragTo(QPointF place);
  void dragWhole(QPointF place);
  void removeAt(QPointF place);
  void addPointAt(QPointF place);
  void chooseCursor(QPointF place, Qt::KeyboardModifiers keys);
  void zoom(double about, double factor);

  void paintHistogram(QPainter& painter) const;
  void paintCurve(QPainter& painter) const;
  void paintPoints(QPainter& painter) const;
  void paintColors(QPainter& painter) const;
  void paintReadings(QPainter& painter) const;

  Kind mKind;
  scene::TransferFunction mTransfer;
  session::AxisView mWhole;
  bool mLogarithmic = true;
  std::optional<double> mProbe;
  Selection mSelection;
  // The hand.
  Drag mDrag = Drag::None;
  scene::TransferFunction mStart;  ///< As it was when the drag began.
  session::AxisView mStartView;
  QPointF mStartPlace;
  QString mStopLabel;       ///< What the drag of a stop is called.
  bool mJustAdded = false;  ///< By the first click of what may become a double click.
};

}  // namespace velum::gui
