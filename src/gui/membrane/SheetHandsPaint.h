#pragma once
#include <QColor>
#include <QPainter>
#include <optional>

#include "scene/Cut.h"
#include "scene/SectionPlane.h"
#include "session/membrane/SheetHands.h"

namespace velum::gui {

/// Which of them are marked.
struct HandMarks {
  session::Hand selected, hover;
};

/// Warm where the sheet is repelled, cool where it is attracted.
QColor strengthColor(double strength);

/// Pins and kernels of a membrane over a view: kernels as three thin rings in the picture, as the circles in which a
/// section cuts their balls there; pins where they are near it.
void paintHands(QPainter& painter, const scene::Cut& cut, const session::ViewSpace& view, const HandMarks& marks);

/// The sign of a pin, its point at a place. Size of its head: pixels.
void drawPin(QPainter& painter, QPointF point, bool hot, bool selected);
/// A small disc with + or -, by which a kernel is held.
void drawKernel(QPainter& painter, QPointF middle, double strength, bool hot, bool selected);

}  // namespace velum::gui
