#pragma once
#include <QColor>
#include <QPainter>
#include <optional>

#include "scene/Cut.h"
#include "scene/SectionPlane.h"
#include "session/membrane/SheetHands.h"

namespace velum::gui {

/// Which pin or kernel is selected, and which is under the pointer.
struct HandMarks {
  session::Hand selected, hover;
};

/// Warm where the sheet is repelled, cool where it is attracted.
QColor strengthColor(double strength);

/// Pins and kernels of a membrane over a view: in the picture a kernel is three thin rings; on a section it is the
/// circle in which the section cuts its ball, and only pins near the section are shown.
void paintHands(QPainter& painter, const scene::Cut& cut, const session::ViewSpace& view, const HandMarks& marks);

/// Draws the sign of a pin with its point at a place of the view, in pixels.
void drawPin(QPainter& painter, QPointF point, bool hot, bool selected);
/// Draws the grip of a kernel, a small disc with + or -.
void drawKernel(QPainter& painter, QPointF middle, double strength, bool hot, bool selected);

}  // namespace velum::gui
