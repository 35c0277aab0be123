#include "gui/tool/HandlePaint.h"

#include <QFontMetrics>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "gui/kit/Theme.h"

namespace velum::gui {

namespace {
const QColor kShade(0, 0, 0, 150);
QColor handleColor(bool hot) { return hot ? QColor(Qt::white) : kHandle; }
}  // namespace

void strokeTwice(QPainter& painter, const QPainterPath& path, const QColor& color, double width) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(0, 0, 0, 110), width + 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(path);
  painter.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(path);
}

void drawKnob(QPainter& painter, QPointF place, bool hot) {
  painter.setPen(QPen(kShade, 1.4));
  painter.setBrush(handleColor(hot));
  double r = hot ? 7.0 : 5.5;
  painter.drawEllipse(place, r, r);
}

void drawGrip(QPainter& painter, QPointF place, QPointF along, bool hot) {
  painter.save();
  painter.translate(place);
  painter.rotate(std::atan2(along.y(), along.x()) * 180.0 / std::numbers::pi);
  painter.setPen(QPen(kShade, 1.4));
  painter.setBrush(handleColor(hot));
  double r = hot ? 6.0 : 4.8;
  painter.drawRoundedRect(QRectF(-r, -r, 2 * r, 2 * r), 1.5, 1.5);
  painter.restore();
}

void drawArrow(QPainter& painter, QPointF foot, QPointF tip, bool hot) {
  QPointF along = tip - foot;
  double length = std::hypot(along.x(), along.y());
  QColor color = handleColor(hot);
  if (length > 20.0) {
    along /= length;
    QPointF aside(-along.y(), along.x());
    QPainterPath shaft(foot);
    shaft.lineTo(tip - along * 12.0);
    strokeTwice(painter, shaft, color, 3.0);
    QPainterPath head(tip + along * 4.0);
    head.lineTo(tip - along * 14.0 + aside * 7.5);
    head.lineTo(tip - along * 14.0 - aside * 7.5);
    head.closeSubpath();
    painter.setPen(QPen(QColor(0, 0, 0, 130), 1.2));
    painter.setBrush(color);
    painter.drawPath(head);
  } else {
    // Seen end on: the ring of an arrow's head.
    painter.setPen(QPen(QColor(0, 0, 0, 130), 1.2));
    painter.setBrush(color);
    painter.drawEllipse(tip, 8.0, 8.0);
    painter.setBrush(QColor(0, 0, 0, 160));
    painter.drawEllipse(tip, 2.5, 2.5);
  }
}

void drawTag(QPainter& painter, QPointF pointer, const QSize& view, const QString& text) {
  if (text.isEmpty()) return;
  QFontMetrics metrics(painter.font());
  QSizeF size(metrics.horizontalAdvance(text) + 16, metrics.height() + 8);
  // To the lower right of the pointer, and on the other side where the view ends.
  QPointF corner = pointer + QPointF(18, 18);
  if (corner.x() + size.width() > view.width()) corner.setX(pointer.x() - 12 - size.width());
  if (corner.y() + size.height() > view.height()) corner.setY(pointer.y() - 12 - size.height());
  QRectF box(corner, size);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0, 0, 0, 190));
  painter.drawRoundedRect(box, 5, 5);
  painter.setPen(Qt::white);
  painter.drawText(box, Qt::AlignCenter, text);
}

void drawHint(QPainter& painter, const QSize& view, const QString& text) {
  if (text.isEmpty()) return;
  // In a narrow view in several lines.
  QRectF most(0, 0, view.width() - 48, view.height());
  QRectF words = painter.boundingRect(most, Qt::AlignHCenter | Qt::TextWordWrap, text);
  QRectF box(0, 15, words.width() + 32, words.height() + 14);
  box.moveLeft(0.5 * (view.width() - box.width()));
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0, 0, 0, 190));
  painter.drawRoundedRect(box, 8, 8);
  painter.setPen(Qt::white);
  painter.drawText(box.adjusted(15, 0, -15, 0), Qt::AlignCenter | Qt::TextWordWrap, text);
}

Qt::CursorShape cursorAlong(QPointF direction) {
  double angle = std::atan2(-direction.y(), direction.x());
  int eighth = int(std::lround(angle / (std::numbers::pi / 4.0))) & 3;
  constexpr Qt::CursorShape kShapes[] = {Qt::SizeHorCursor, Qt::SizeBDiagCursor, Qt::SizeVerCursor,
                                         Qt::SizeFDiagCursor};
  return kShapes[eighth];
}

}  // namespace velum::gui
