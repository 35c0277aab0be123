#pragma once
#include <QWidget>
#include <functional>
#include <optional>

#include "session/look/ValueHistogram.h"

namespace velum::gui {

QColor faded(QColor color, double alpha);
QFont smallFont(const QFont& font);

/// The base of canvases that show a curve of points over a histogram: it places values on the axis, draws what all such
/// canvases have in common, and hears the keys. A derived class has the curve and decides how the mouse edits it. The
/// canvas changes no data itself: it tells by signals what the curve would become.
class CurveCanvas : public QWidget {
  Q_OBJECT
 public:
  void setHistogram(const Histogram& histogram);
  void setUnit(const QString& unit);
  session::AxisView view() const { return mView; }

 signals:
  /// A change that was made step by step is complete.
  void settled();

 protected:
  /// @param below  pixels between the plot and the axis
  CurveCanvas(int plotHeight, int below, QWidget* parent);
  /// Where plot and axis are, in widget pixels.
  QRectF plot() const;
  QRectF axis() const;
  double xOf(double value) const;
  void setAxis(session::AxisView view);
  const QString& unit() const { return mUnit; }
  const std::optional<QPointF>& hover() const { return mHover; }
  void setHover(QPointF place) { mHover = place; }

  /// @param inside  paints the contents, clipped to the ground
  void paintGround(QPainter& painter, const std::function<void()>& inside) const;
  /// @param share  of the plot's height that the highest bar takes
  void paintBars(QPainter& painter, double share, bool logarithmic) const;
  void paintPoint(QPainter& painter, QPointF place, const QColor& color, bool isSelected) const;
  /// @param asScale  with a mark at each number, and with the unit
  void paintAxis(QPainter& painter, bool asScale) const;

  /// True for a key that the canvas uses while it has the keyboard, although the window has a command on that key.
  virtual bool isOwnKey(int key) const = 0;
  virtual void step(int sideways, int up, bool wide) = 0;
  virtual void selectNext(int by) = 0;
  virtual void addBeside() = 0;
  virtual void removeSelected() = 0;

  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  const int mPlotHeight;
  Histogram mHistogram;
  session::AxisView mView;
  QString mUnit;
  std::optional<QPointF> mHover;
};

}  // namespace velum::gui
