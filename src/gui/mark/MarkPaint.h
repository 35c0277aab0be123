#pragma once
#include "gui/tool/Manipulator.h"
#include "scene/Scene.h"

namespace velum::gui {

/// Paints the lines and the words of a mark over a view, as much of it as the view shows.
void paintMark(ViewPainter& over, const scene::Scene& scene, const scene::Mark& mark, const QColor& color);
/// Half the width and the height of the words of a mark, pixels; 0: it has none.
glm::dvec2 halfWords(const scene::Scene& scene, const scene::Mark& mark);

}  // namespace velum::gui
