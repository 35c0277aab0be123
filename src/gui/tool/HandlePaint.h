#pragma once
#include <QColor>
#include <QPainter>
#include <QPainterPath>

namespace velum::gui {

/// How handles look over pictures and sections alike.

/// Lines are drawn twice, dark and wide below, so that they can be seen over light and dark tissue.
void strokeTwice(QPainter& painter, const QPainterPath& path, const QColor& color, double width);
void drawKnob(QPainter& painter, QPointF place, bool hot);
/// A square that stands for a face which is moved. @param along  screen direction in which it goes
void drawGrip(QPainter& painter, QPointF place, QPointF along, bool hot);
void drawArrow(QPainter& painter, QPointF foot, QPointF tip, bool hot);
/// Numbers beside the pointer.
void drawTag(QPainter& painter, QPointF pointer, const QSize& view, const QString& text);
/// A line at the top of a view that says what to do next.
void drawHint(QPainter& painter, const QSize& view, const QString& text);
/// The cursor for something that goes along a direction of the screen.
Qt::CursorShape cursorAlong(QPointF direction);

}  // namespace velum::gui
