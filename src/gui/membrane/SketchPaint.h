#pragma once
#include "tool/Manipulator.h"
#include "velum/scene/Membrane.h"

namespace velum::gui {

/// A stroke over a view: on a section the part of it that lies in its plane; in the 3D view, faintly, all of it.
void paintStroke(ViewPainter& over, const scene::Stroke& stroke, bool isMarked);
/// The brush under the pointer.
void paintBrush(ViewPainter& over, QPointF pointer, double radius, bool avoid);

}  // namespace velum::gui
