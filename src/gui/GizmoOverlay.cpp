#include "GizmoOverlay.h"

#include <QPainter>
#include <QPainterPath>
#include <cmath>
#include <numbers>

#include "Theme.h"
#include "velum/scene/Project.h"

namespace velum::gui {

namespace {

using session::CutHandle;

/// Lines are drawn twice, dark and wide below, so that they can be seen over light and dark tissue.
void strokeTwice(QPainter& painter, const QPainterPath& path, const QColor& color, double width) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(0, 0, 0, 110), width + 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(path);
  painter.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(path);
}

/// World to widget, for one camera.
class Projector {
 public:
  Projector(const scene::Camera& camera, glm::dvec2 size) : mCamera(camera), mSize(size) {}
  std::optional<QPointF> operator()(glm::dvec3 world) const {
    auto pixel = scene::pixelFromWorld(mCamera, mSize, world);
    if (!pixel) return std::nullopt;
    return QPointF(pixel->x, pixel->y);
  }
  /// A closed line; empty when a part of it lies behind the eye.
  QPainterPath ring(const std::vector<glm::dvec3>& points) const {
    QPolygonF polygon;
    for (const auto& p : points) {
      auto place = (*this)(p);
      if (!place) return {};
      polygon << *place;
    }
    QPainterPath path;
    path.addPolygon(polygon);
    path.closeSubpath();
    return path;
  }

 private:
  const scene::Camera& mCamera;
  glm::dvec2 mSize;
};

std::vector<glm::dvec3> circlePoints(const session::CutGizmo& gizmo) {
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 72; ++i) {
    double a = 2.0 * std::numbers::pi * i / 72.0;
    points.push_back(gizmo.centreMm + (gizmo.right * std::cos(a) + gizmo.top * std::sin(a)) * gizmo.radiusMm);
  }
  return points;
}

void drawArrow(QPainter& painter, QPointF foot, QPointF tip, const QColor& color) {
  QPointF along = tip - foot;
  double length = std::hypot(along.x(), along.y());
  if (length > 20.0) {
    along /= length;
    QPointF aside(-along.y(), along.x());
    QPainterPath shaft(foot);
    shaft.lineTo(tip - along * 12.0);
    strokeTwice(painter, shaft, color, 3.0);
    QPainterPath head(tip + along * 4.0);
    head.lineTo(tip - along * 14.0 + aside * 7.5);
    head.lineTo(tip - along * 14.0 - aside * 7.5);
    head.closeSubpath();
    painter.setPen(QPen(QColor(0, 0, 0, 130), 1.2));
    painter.setBrush(color);
    painter.drawPath(head);
  } else {
    // Seen end on: the ring of an arrow's head.
    painter.setPen(QPen(QColor(0, 0, 0, 130), 1.2));
    painter.setBrush(color);
    painter.drawEllipse(tip, 8.0, 8.0);
    painter.setBrush(QColor(0, 0, 0, 160));
    painter.drawEllipse(tip, 2.5, 2.5);
  }
}

void drawKnob(QPainter& painter, QPointF place, bool hot) {
  painter.setPen(QPen(QColor(0, 0, 0, 150), 1.4));
  painter.setBrush(hot ? QColor(Qt::white) : kHandle);
  painter.drawEllipse(place, hot ? 7.0 : 5.5, hot ? 7.0 : 5.5);
}

}  // namespace

GizmoOverlay::GizmoOverlay(const session::Document& document, QWidget* parent) : QWidget(parent), mDocument(document) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
}

void GizmoOverlay::showCut(int index) {
  mCut = index;
  update();
}

void GizmoOverlay::setHover(CutHandle handle) {
  if (mHover == handle) return;
  mHover = handle;
  update();
}

void GizmoOverlay::paintEvent(QPaintEvent*) {
  const scene::Scene& scene = mDocument.scene();
  if (mCut < 0 || mCut >= int(scene.cuts.size())) return;
  const scene::Cut& cut = scene.cuts[std::size_t(mCut)];
  glm::dvec2 size(std::max(1, width()), std::max(1, height()));
  session::CutGizmo gizmo = session::makeCutGizmo(scene, cut, size);
  Projector project(scene.camera, size);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setOpacity(cut.enabled ? 1.0 : 0.45);
  if (QPainterPath outline = project.ring(gizmo.outlineMm); !outline.isEmpty()) {
    painter.fillPath(outline, QColor(kHandle.red(), kHandle.green(), kHandle.blue(), 14));
    strokeTwice(painter, outline, QColor(kHandle.red(), kHandle.green(), kHandle.blue(), 200), 1.3);
  }
  for (const auto& edge : gizmo.edgesMm)
    if (QPainterPath line = project.ring(edge); !line.isEmpty())
      strokeTwice(painter, line, QColor(kHandle.red(), kHandle.green(), kHandle.blue(), 120), 1.0);
  if (QPainterPath ring = project.ring(circlePoints(gizmo)); !ring.isEmpty())
    strokeTwice(painter, ring, QColor(255, 236, 210, 210), 1.6);
  auto foot = project(gizmo.centreMm), tip = project(gizmo.arrowTipMm);
  for (auto knob : {CutHandle::KnobRight, CutHandle::KnobTop, CutHandle::KnobLeft, CutHandle::KnobBottom})
    if (auto place = project(session::handlePlaceMm(gizmo, knob))) drawKnob(painter, *place, mHover == knob);
  if (foot && tip) drawArrow(painter, *foot, *tip, mHover == CutHandle::Arrow ? QColor(Qt::white) : kHandle);
}

}  // namespace velum::gui
