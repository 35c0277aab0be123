#include "gui/extrusion/PullPaint.h"

#include <QPainterPath>
#include <vector>

#include "gui/kit/Theme.h"
#include "gui/tool/HandlePaint.h"
#include "session/cut/CutGizmo.h"
#include "session/extrusion/Extrusion.h"

namespace velum::gui {

namespace {

constexpr double kLine = 1.4, kThinLine = 1.0;
constexpr int kPale = 46, kWire = 90;

QColor withAlpha(QColor color, int alpha) {
  color.setAlpha(alpha);
  return color;
}

/// A line, closed or not; empty when a part of it lies behind the eye.
QPainterPath pathOf(const session::ViewSpace& view, const std::vector<glm::dvec3>& points, bool isClosed) {
  QPolygonF polygon;
  for (const auto& point : points) {
    auto pixel = view.pixelFromWorld(point);
    if (!pixel) return {};
    polygon << QPointF(pixel->x, pixel->y);
  }
  QPainterPath path;
  path.addPolygon(polygon);
  if (isClosed) path.closeSubpath();
  return path;
}

void paintBox(ViewPainter& over, const scene::Scene& scene) {
  for (const auto& edge : session::boxEdges(scene))
    strokeTwice(over.painter, pathOf(over.space, edge, false), withAlpha(kOverPicture, kWire), kThinLine);
}

}  // namespace

void paintPlanes(ViewPainter& over, const scene::Scene& scene, int supporting) {
  paintBox(over, scene);
  for (const auto& cut : scene.cuts) {
    if (cut.shape != scene::CutShape::Plane || !session::canPullFrom(cut)) continue;
    auto outline = session::makeCutGizmo(scene, cut, over.space.size()).outline;
    if (outline.empty()) continue;
    for (const auto& pale : session::partsLeftByOthers(scene, cut, outline))
      over.painter.fillPath(pathOf(over.space, pale, true), withAlpha(kOverPicture, kPale));
    double width = cut.id == supporting ? 2.0 * kLine : kLine;
    strokeTwice(over.painter, pathOf(over.space, outline, true), withAlpha(kHandle, 220), width);
  }
}

}  // namespace velum::gui
