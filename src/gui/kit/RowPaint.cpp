#include "RowPaint.h"

#include <QPainterPath>

namespace velum::gui {

namespace {
QPen thin(const QColor& color) { return {color, 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin}; }
}  // namespace

void paintEye(QPainter& painter, const QRectF& box, const QColor& color, bool open) {
  QPointF c = box.center();
  constexpr double kWide = 7.0, kTall = 6.5;
  QPainterPath lid(c + QPointF(-kWide, 0));
  painter.setPen(thin(color));
  painter.setBrush(Qt::NoBrush);
  if (!open) {
    lid.quadTo(c + QPointF(0, kTall), c + QPointF(kWide, 0));
    painter.drawPath(lid);
    return;
  }
  lid.quadTo(c + QPointF(0, -kTall * 1.25), c + QPointF(kWide, 0));
  lid.quadTo(c + QPointF(0, kTall * 1.25), c + QPointF(-kWide, 0));
  painter.drawPath(lid);
  painter.setBrush(color);
  painter.setPen(Qt::NoPen);
  painter.drawEllipse(c, 2.2, 2.2);
}

void paintShape(QPainter& painter, const QRectF& box, const QColor& color, scene::CutShape shape) {
  QPointF c = box.center();
  painter.setPen(thin(color));
  painter.setBrush(Qt::NoBrush);
  switch (shape) {
    case scene::CutShape::Plane:
      painter.drawPolygon(
          QPolygonF{c + QPointF(-6, -1), c + QPointF(2, -5.5), c + QPointF(6, 1), c + QPointF(-2, 5.5)});
      break;
    case scene::CutShape::Box:
      painter.drawRect(QRectF(c + QPointF(-6, -2.5), c + QPointF(2.5, 6)));
      painter.drawPolyline(QPolygonF{c + QPointF(-6, -2.5), c + QPointF(-2.5, -6), c + QPointF(6, -6),
                                     c + QPointF(6, 2.5), c + QPointF(2.5, 6)});
      painter.drawLine(c + QPointF(2.5, -2.5), c + QPointF(6, -6));
      break;
    case scene::CutShape::Sphere:
      painter.drawEllipse(c, 6, 6);
      painter.drawArc(QRectF(c + QPointF(-6, -2.2), c + QPointF(6, 2.2)), 180 * 16, 180 * 16);
      break;
    case scene::CutShape::Cylinder:
      painter.drawEllipse(c + QPointF(0, -4), 4.5, 2);
      painter.drawLine(c + QPointF(-4.5, -4), c + QPointF(-4.5, 4));
      painter.drawLine(c + QPointF(4.5, -4), c + QPointF(4.5, 4));
      painter.drawArc(QRectF(c + QPointF(-4.5, 2), c + QPointF(4.5, 6)), 180 * 16, 180 * 16);
      break;
    case scene::CutShape::Cone:
      painter.drawEllipse(c + QPointF(0, -4), 5, 2);
      painter.drawPolyline(QPolygonF{c + QPointF(-5, -4), c + QPointF(0, 6), c + QPointF(5, -4)});
      break;
    case scene::CutShape::Membrane: {  // a sheet that goes up around something and down again
      QPainterPath wave(c + QPointF(-6.5, 2.5));
      wave.cubicTo(c + QPointF(-2.5, 2.5), c + QPointF(-3.5, -5), c + QPointF(0, -5));
      wave.cubicTo(c + QPointF(3.5, -5), c + QPointF(2.5, 2.5), c + QPointF(6.5, 2.5));
      painter.drawPath(wave);
      painter.drawEllipse(c + QPointF(0, 0.5), 2, 2);
      break;
    }
  }
}

void paintSwatch(QPainter& painter, const QRectF& box, const QColor& color, const QColor& line) {
  painter.setPen(QPen(line, 1.0));
  painter.setBrush(color);
  painter.drawRoundedRect(box, 3, 3);
}

void paintRowGround(QPainter& painter, const QStyleOptionViewItem& option, bool isFirst, bool isLast) {
  bool selected = option.state & QStyle::State_Selected;
  if (!selected && !(option.state & QStyle::State_MouseOver)) return;
  QColor color = option.palette.color(QPalette::Highlight);
  if (!selected) color.setAlphaF(0.25);
  constexpr double kRound = 4.0;
  QRectF row = QRectF(option.rect).adjusted(isFirst ? 1 : -kRound, 0, isLast ? -1 : kRound, 0);
  painter.save();
  painter.setClipRect(option.rect);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawRoundedRect(row, kRound, kRound);
  painter.restore();
}

EyeButton::EyeButton(QWidget* parent) : QToolButton(parent) {
  setCheckable(true);
  setFixedSize(28, 26);
}

void EyeButton::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (hasFocus() || underMouse()) {
    QColor ground = palette().color(QPalette::Highlight);
    ground.setAlphaF(0.25);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawRoundedRect(rect(), 4, 4);
  }
  paintEye(painter, rect(), palette().color(isChecked() ? QPalette::Text : QPalette::PlaceholderText), isChecked());
}

QColor rowTextColor(const QStyleOptionViewItem& option, bool isStrong) {
  bool selected = option.state & QStyle::State_Selected;
  QColor color = option.palette.color(selected ? QPalette::HighlightedText : QPalette::Text);
  if (!isStrong)
    color = selected ? QColor(color.red(), color.green(), color.blue(), 170)
                     : option.palette.color(QPalette::PlaceholderText);
  return color;
}

}  // namespace velum::gui
