#pragma once
#include <QColor>
#include <QPainter>
#include <QPainterPath>

namespace velum::gui {

/// How handles look over pictures and sections alike.

/// Draws a line twice, first dark and wide, then in its colour, so that it can be seen over light and dark tissue.
void strokeTwice(QPainter& painter, const QPainterPath& path, const QColor& color, double width);
void drawKnob(QPainter& painter, QPointF place, bool hot);
/// Draws a square that stands for a face that can be moved. @param along  direction of the screen in which the face
/// moves
void drawGrip(QPainter& painter, QPointF place, QPointF along, bool hot);
void drawArrow(QPainter& painter, QPointF foot, QPointF tip, bool hot);
/// Draws a text beside the pointer, such as numbers.
void drawTag(QPainter& painter, QPointF pointer, const QSize& view, const QString& text);
/// Draws a line at the top of a view that says what to do next.
void drawHint(QPainter& painter, const QSize& view, const QString& text);
/// The cursor for a handle that moves along a direction of the screen.
Qt::CursorShape cursorAlong(QPointF direction);

}  // namespace velum::gui
