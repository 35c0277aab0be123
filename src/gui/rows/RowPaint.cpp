#include "gui/rows/RowPaint.h"

#include <QPainterPath>
#include <QTextStream>

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

void paintIcon(QPainter& painter, const QRectF& box, const QColor& color, const char* lines) {
  QPainterPath path;
  QTextStream text{QByteArray(lines)};
  auto point = [&] {
    double x = 0, y = 0;
    text >> x >> y;
    return box.center() + QPointF(x, y);
  };
  auto around = [&] {
    QPointF middle = point(), half = point() - box.center();
    return QRectF(middle - half, middle + half);
  };
  QString letter;
  while (text >> letter, !letter.isEmpty()) {
    if (letter == "M") path.moveTo(point());
    if (letter == "L") path.lineTo(point());
    if (letter == "Z") path.closeSubpath();
    if (letter == "O") path.addEllipse(around());
    if (letter == "U") {
      QRectF whole = around();
      path.arcMoveTo(whole, 180);
      path.arcTo(whole, 180, 180);
    }
    if (letter == "C") {
      QPointF a = point(), b = point(), to = point();
      path.cubicTo(a, b, to);
    }
  }
  painter.setPen(thin(color));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(path);
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
  if (selected) return option.palette.color(QPalette::HighlightedText);  // a paler one cannot be read on what is chosen
  return option.palette.color(isStrong ? QPalette::Text : QPalette::PlaceholderText);
}

}  // namespace velum::gui
