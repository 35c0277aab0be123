#pragma once
#include <span>

#include "gui/tool/Manipulator.h"

namespace velum::gui {

/// Paints a stroke over a view: on a section only the part of the stroke that lies in the section's plane; in the 3D
/// view the whole stroke, faintly. @param path  places in the world  @param radius  half the stroke's width, a length
void paintStroke(ViewPainter& over, std::span<const glm::dvec3> path, double radius, const QColor& color,
                 bool isMarked);
/// Paints the outline of the brush under the pointer. @param radius  a length
void paintBrush(ViewPainter& over, QPointF pointer, double radius, const QColor& color);

}  // namespace velum::gui
