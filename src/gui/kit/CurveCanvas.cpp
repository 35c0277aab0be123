#include "gui/kit/CurveCanvas.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "gui/kit/Words.h"

namespace velum::gui {

namespace {
constexpr int kMargin = 9, kAxisHeight = 18;
}

QColor faded(QColor color, double alpha) {
  color.setAlphaF(float(alpha));
  return color;
}

QFont smallFont(const QFont& font) {
  QFont small = font;
  small.setPointSizeF(font.pointSizeF() * 0.82);
  return small;
}

CurveCanvas::CurveCanvas(int plotHeight, int below, QWidget* parent) : QWidget(parent), mPlotHeight(plotHeight) {
  setFixedHeight(kMargin + plotHeight + below + kAxisHeight);
  setMinimumWidth(200);
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QRectF CurveCanvas::plot() const { return QRectF(kMargin, kMargin, std::max(1, width() - 2 * kMargin), mPlotHeight); }

QRectF CurveCanvas::axis() const { return QRectF(0, height() - kAxisHeight, width(), kAxisHeight); }

double CurveCanvas::xOf(double value) const {
  return plot().left() + (value - mView.low) / (mView.high - mView.low) * plot().width();
}

void CurveCanvas::setHistogram(const Histogram& histogram) {
  mHistogram = histogram;
  update();
}

void CurveCanvas::setAxis(session::AxisView view) {
  mView = view;
  update();
}

void CurveCanvas::setUnit(const QString& unit) {
  mUnit = unit;
  update();
}

void CurveCanvas::paintGround(QPainter& painter, const std::function<void()>& inside) const {
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath ground;
  ground.addRoundedRect(plot().adjusted(-3, -3, 3, 3), 5, 5);
  painter.fillPath(ground, palette().color(QPalette::Base));
  painter.save();
  painter.setClipPath(ground);
  inside();
  painter.restore();
  if (!hasFocus()) return;
  painter.setPen(QPen(faded(palette().color(QPalette::Link), 0.7), 1.0));
  painter.drawPath(ground);
}

void CurveCanvas::paintBars(QPainter& painter, double share, bool logarithmic) const {
  QRectF p = plot();
  double bottom = p.bottom() + 3;
  int columns = std::max(1, int(p.width()));
  auto heights = session::histogramHeights(mHistogram, mView, columns, logarithmic);
  QPainterPath bars(QPointF(p.left(), bottom));
  for (int i = 0; i < columns; ++i)
    bars.lineTo(p.left() + i + 0.5, bottom - heights[std::size_t(i)] * share * p.height());
  bars.lineTo(p.right(), bottom);
  painter.fillPath(bars, faded(palette().color(QPalette::PlaceholderText), 0.30));
}

void CurveCanvas::paintPoint(QPainter& painter, QPointF place, const QColor& color, bool isSelected) const {
  if (isSelected) {
    painter.setPen(QPen(palette().color(QPalette::Link), 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(place, 7.5, 7.5);
  }
  painter.setPen(QPen(palette().color(QPalette::Text), 1.3));
  painter.setBrush(color);
  painter.drawEllipse(place, 4.5, 4.5);
}

void CurveCanvas::paintAxis(QPainter& painter, bool asScale) const {
  painter.setFont(smallFont(font()));
  painter.setPen(palette().color(QPalette::PlaceholderText));
  QFontMetricsF metrics(painter.font());
  auto ticks = session::axisTicks(mView, std::clamp(int(plot().width() / 50), 2, 8));
  double free = -1e9;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    QString text = localNumber(session::axisNumber(ticks[i], mView));
    if (asScale && i + 1 == ticks.size() && !mUnit.isEmpty()) text += " " + mUnit;
    double wide = metrics.horizontalAdvance(text), x = xOf(ticks[i]);
    double left = std::clamp(x - 0.5 * wide, 1.0, width() - wide - 1.0);
    if (left < free) continue;
    if (asScale) painter.drawLine(QPointF(x, axis().top()), QPointF(x, axis().top() + 3));
    painter.drawText(QPointF(left, axis().bottom() - 3), text);
    free = left + wide + 6;
  }
}

bool CurveCanvas::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && isOwnKey(static_cast<QKeyEvent*>(event)->key())) event->accept();
  return QWidget::event(event);
}

/// PgUp and PgDn select the next point, arrows move the selected point, Ins adds a point beside it, Del removes it.
void CurveCanvas::keyPressEvent(QKeyEvent* event) {
  bool wide = event->modifiers() & Qt::ShiftModifier;
  switch (event->key()) {
    case Qt::Key_Left:
      return step(-1, 0, wide);
    case Qt::Key_Right:
      return step(1, 0, wide);
    case Qt::Key_Up:
      return step(0, 1, wide);
    case Qt::Key_Down:
      return step(0, -1, wide);
    case Qt::Key_PageUp:
      return selectNext(-1);
    case Qt::Key_PageDown:
      return selectNext(1);
    case Qt::Key_Insert:
      return addBeside();
    case Qt::Key_Delete:
      return removeSelected();
    default:
      QWidget::keyPressEvent(event);
  }
}

void CurveCanvas::leaveEvent(QEvent*) {
  mHover.reset();
  update();
}

}  // namespace velum::gui
