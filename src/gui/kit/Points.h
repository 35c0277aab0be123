#pragma once
#include <QPointF>
#include <glm/glm.hpp>

namespace velum::gui {

/// Points in pixels, from Qt's type to glm's and back.
inline glm::dvec2 toVec(QPointF p) { return {p.x(), p.y()}; }
inline QPointF toPoint(glm::dvec2 p) { return {p.x, p.y}; }

}  // namespace velum::gui
