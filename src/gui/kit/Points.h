#pragma once
#include <QPointF>
#include <glm/glm.hpp>

namespace velum::gui {

/// Pixels as Qt has them, and as mathematics has.
inline glm::dvec2 toVec(QPointF p) { return {p.x(), p.y()}; }
inline QPointF toPoint(glm::dvec2 p) { return {p.x, p.y}; }

}  // namespace velum::gui
