// What a transfer function looks like; the hand on it is in TransferCanvasMouse.cpp.
#include "gui/look/TransferCanvas.h"

#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "gui/kit/Words.h"
#include "scene/Scene.h"

namespace velum::gui {

namespace {

constexpr int kPlotHeight = 136, kLowPlotHeight = 62, kBarGap = 6, kBarHeight = 13, kStopHeight = 12;

QColor qColor(glm::dvec3 color) {
  color = glm::clamp(color, 0.0, 1.0);
  return QColor::fromRgbF(float(color.r), float(color.g), float(color.b));
}

QString percent(double share) {
  double value = 100.0 * share;
  return QLocale().toString(value, 'f', value > 0 && value < 9.95 ? 1 : 0) + " %";
}

/// The colours along the axis, a pixel each, left to right: gradients of Qt have bands.
QImage colorsAlong(const session::CurveFrame& frame, const session::Stops& stops) {
  QImage image(std::max(1, int(frame.size.x)), 1, QImage::Format_RGB32);
  for (int i = 0; i < image.width(); ++i)
    image.setPixelColor(i, 0, qColor(scene::colorAt(stops, session::valueAtX(frame, frame.topLeft.x + i + 0.5))));
  return image;
}

QPainterPath pathOf(const std::vector<glm::dvec2>& points) {
  QPainterPath path;
  for (std::size_t i = 0; i < points.size(); ++i)
    i == 0 ? path.moveTo(points[i].x, points[i].y) : path.lineTo(points[i].x, points[i].y);
  return path;
}

}  // namespace

TransferCanvas::TransferCanvas(Kind kind, QWidget* parent)
    : CurveCanvas(kind == Kind::Values ? kPlotHeight : kLowPlotHeight,
                  kind == Kind::Values ? kBarGap + kBarHeight + kStopHeight : 0, parent),
      mKind(kind) {}

session::CurveFrame TransferCanvas::frame() const {
  // On the axis of opacities the faint ones have more room; the axis of factors is even.
  QRectF p = plot();
  return {{p.left(), p.top()}, {p.width(), p.height()}, view(), hasColors() ? 0.5 : 1.0};
}

QRectF TransferCanvas::barRect() const {
  if (!hasColors()) return {};
  return {plot().left(), plot().bottom() + kBarGap, plot().width(), double(kBarHeight)};
}

void TransferCanvas::setTransfer(const scene::TransferFunction& transfer) {
  if (transfer == mTransfer) return;
  mTransfer = transfer;
  std::size_t count = mSelection.part == Selection::Part::Stop ? mTransfer.colors.size() : curve().size();
  if (mSelection.index >= int(count)) mSelection = {};
  update();
  emit selectionChanged();  // its numbers may have changed
}

void TransferCanvas::setWhole(session::AxisView whole) {
  mWhole = whole.high > whole.low ? whole : session::AxisView{whole.low, whole.low + 1.0};
}

void TransferCanvas::setView(session::AxisView view) { setAxis(view.high > view.low ? view : mWhole); }

void TransferCanvas::setLogarithmic(bool logarithmic) {
  mLogarithmic = logarithmic;
  update();
}

void TransferCanvas::setProbe(std::optional<double> value) {
  if (value == mProbe) return;
  mProbe = value;
  update();
}

void TransferCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (!isEnabled()) painter.setOpacity(0.45);
  paintGround(painter, [&] {
    paintHistogram(painter);
    paintCurve(painter);
    paintReadings(painter);
  });
  paintPoints(painter);
  if (hasColors()) paintColors(painter);
  paintAxis(painter, true);
}

void TransferCanvas::paintHistogram(QPainter& painter) const {
  session::CurveFrame f = frame();
  paintBars(painter, 0.94, mLogarithmic);
  // Heights that can be named.
  painter.setFont(smallFont(font()));
  for (double opacity : {0.01, 0.1, 0.5}) {
    if (!hasColors() && opacity != 0.5) continue;
    double y = std::round(session::yOf(f, opacity)) + 0.5;
    painter.setPen(faded(palette().color(QPalette::Text), 0.10));
    painter.drawLine(QPointF(f.topLeft.x - 3, y), QPointF(f.topLeft.x + f.size.x + 3, y));
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(QRectF(f.topLeft.x + 1, y - 15, f.size.x - 2, 14), Qt::AlignLeft | Qt::AlignBottom,
                     QString("%1 %").arg(int(100 * opacity)));
  }
}

void TransferCanvas::paintCurve(QPainter& painter) const {
  if (curve().empty()) return;
  session::CurveFrame f = frame();
  QPainterPath line = pathOf(session::outlineOf(f, curve()));
  QPainterPath area = line;
  area.lineTo(f.topLeft.x + f.size.x, f.topLeft.y + f.size.y + 3);
  area.lineTo(f.topLeft.x, f.topLeft.y + f.size.y + 3);
  area.closeSubpath();
  if (hasColors()) {
    painter.save();
    painter.setClipPath(area, Qt::IntersectClip);
    painter.setOpacity(0.62 * painter.opacity());
    painter.drawImage(QRectF(f.topLeft.x, 0, f.size.x, height()), colorsAlong(f, mTransfer.colors));
    painter.restore();
  } else {
    painter.fillPath(area, faded(palette().color(QPalette::Link), 0.20));
  }
  painter.setPen(QPen(palette().color(QPalette::Text), 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(line);
}

void TransferCanvas::paintPoints(QPainter& painter) const {
  session::CurveFrame f = frame();
  for (std::size_t i = 0; i < curve().size(); ++i) {
    const auto& point = curve()[i];
    if (point.value < view().low || point.value > view().high) continue;
    paintPoint(painter, {session::xOf(f, point.value), session::yOf(f, point.opacity)},
               hasColors() ? qColor(scene::colorAt(mTransfer.colors, point.value)) : palette().color(QPalette::Base),
               mSelection == Selection{Selection::Part::Point, int(i)});
  }
}

void TransferCanvas::paintColors(QPainter& painter) const {
  session::CurveFrame f = frame();
  QRectF bar = barRect();
  QPainterPath shape;
  shape.addRoundedRect(bar, 3, 3);
  painter.save();
  painter.setClipPath(shape, Qt::IntersectClip);
  painter.drawImage(bar, colorsAlong(f, mTransfer.colors));
  painter.restore();
  for (std::size_t i = 0; i < mTransfer.colors.size(); ++i) {
    const auto& stop = mTransfer.colors[i];
    if (stop.value < view().low || stop.value > view().high) continue;
    bool chosen = mSelection == Selection{Selection::Part::Stop, int(i)};
    double x = session::xOf(f, stop.value), top = bar.bottom() - 3;
    QPainterPath pin(QPointF(x, top));
    pin.lineTo(x + 5, top + 6);
    pin.lineTo(x + 5, top + 13);
    pin.lineTo(x - 5, top + 13);
    pin.lineTo(x - 5, top + 6);
    pin.closeSubpath();
    painter.setPen(QPen(palette().color(chosen ? QPalette::Link : QPalette::Text), chosen ? 2.2 : 1.1, Qt::SolidLine,
                        Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(qColor(stop.color));
    painter.drawPath(pin);
  }
}

/// The value under the pointer of a view, and value and opacity under the pointer here.
void TransferCanvas::paintReadings(QPainter& painter) const {
  session::CurveFrame f = frame();
  double top = f.topLeft.y - 3, bottom = f.topLeft.y + f.size.y + 3;
  painter.setFont(smallFont(font()));
  QString name = unit().isEmpty() ? QString() : " " + unit();
  if (mProbe && *mProbe >= view().low && *mProbe <= view().high) {
    double x = session::xOf(f, *mProbe);
    painter.setPen(QPen(palette().color(QPalette::Link), 1.0));
    painter.drawLine(QPointF(x, top), QPointF(x, bottom));
  }
  std::optional<double> value = mProbe;
  if (hover() && mDrag != Drag::Axis && hover()->y() < bottom + kBarHeight + kStopHeight)
    value = session::valueAtX(f, hover()->x());
  if (!value || curve().empty()) return;
  QString text =
      QString("%1%2   %3")
          .arg(localNumber(session::axisNumber(*value, view())), name, percent(scene::opacityAt(curve(), *value)));
  QRectF box(f.topLeft.x + 1, top + 3, QFontMetricsF(painter.font()).horizontalAdvance(text) + 8, 16);
  painter.setPen(Qt::NoPen);
  painter.setBrush(faded(palette().color(QPalette::Base), 0.72));
  painter.drawRoundedRect(box, 3, 3);
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(box, Qt::AlignCenter, text);
}

}  // namespace velum::gui
