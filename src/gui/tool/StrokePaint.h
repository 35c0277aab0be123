#pragma once
#include <span>

#include "gui/tool/Manipulator.h"

namespace velum::gui {

/// A stroke over a view: on a section the part of it that lies in its plane; in the 3D view, faintly, all of it.
/// @param path  world  @param radius  half its width
void paintStroke(ViewPainter& over, std::span<const glm::dvec3> path, double radius, const QColor& color,
                 bool isMarked);
/// The brush under the pointer.
void paintBrush(ViewPainter& over, QPointF pointer, double radius, const QColor& color);

}  // namespace velum::gui
