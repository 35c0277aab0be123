#pragma once
#include <optional>

#include "gui/kit/CurveCanvas.h"

namespace velum::gui {

/// Shows a transfer function over a histogram and lets the user edit it: points of the opacity curve, stops in the
/// colour bar, the value axis. The canvas changes no data itself: it tells by signals what the function would become.
class TransferCanvas : public CurveCanvas {
  Q_OBJECT
 public:
  /// Values: opacity and colour by value. Gradients: only the factor by gradient length, on a lower canvas without
  /// colours.
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
  /// Sets the whole range that the axis can show.
  void setWhole(session::AxisView whole);
  /// Sets the part of the range that the axis shows; before the first call it shows all of it.
  void setView(session::AxisView view);
  void setLogarithmic(bool logarithmic);
  /// Draws a thin line at the value that is under the pointer in another view; std::nullopt takes the line away.
  void setProbe(std::optional<double> value);

  void select(Selection selection);
  Selection selection() const { return mSelection; }
  void removeSelected() override;
  /// Sets the selected point's or stop's value, and the point's opacity.
  void moveSelected(double value, double opacity);
  void colorSelected(glm::vec3 color);

  /// Where plot, colour bar and axis are, in widget pixels; for tests.
  session::CurveFrame frame() const;
  QRectF barRect() const;
  QRectF axisRect() const { return axis(); }

 signals:
  /// The user has edited the function, which becomes `next`. @param merge  the edit is part of a drag, which ends with
  /// settled()
  void edited(const QString& label, const velum::scene::TransferFunction& next, bool merge);
  void selectionChanged();
  /// A stop was double clicked: the user wants to give it another colour.
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
  /// Line: the curve was pressed. Once the pointer moves, its direction decides for Shift or Scale; a press that does
  /// not move adds a point.
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
  // The drag that goes on.
  Drag mDrag = Drag::None;
  scene::TransferFunction mStart;  ///< The function as it was when the drag began.
  session::AxisView mStartView;
  QPointF mStartPlace;
  QString mStopLabel;       ///< The name of the undo step of a stop's drag.
  bool mJustAdded = false;  ///< The first click of a possible double click has added a point or a stop.
};

}  // namespace velum::gui
