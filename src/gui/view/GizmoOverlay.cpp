#include "GizmoOverlay.h"

#include <QPainter>
#include <QPainterPath>
#include <cmath>

#include "GizmoPaint.h"
#include "kit/Theme.h"
#include "velum/scene/Project.h"

namespace velum::gui {

namespace {

using session::CutHandle;

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
  /// Screen direction of a world direction at a place.
  QPointF along(glm::dvec3 place, glm::dvec3 direction, double mm) const {
    auto a = (*this)(place), b = (*this)(place + direction * mm);
    return a && b ? *b - *a : QPointF(1, 0);
  }

 private:
  const scene::Camera& mCamera;
  glm::dvec2 mSize;
};

QColor withAlpha(QColor color, int alpha) {
  color.setAlpha(alpha);
  return color;
}

bool isResize(CutHandle handle) { return handle >= CutHandle::FaceXMin; }

}  // namespace

GizmoOverlay::GizmoOverlay(const session::Document& document, QWidget* parent) : QWidget(parent), mDocument(document) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
}

void GizmoOverlay::showCut(int id) {
  mCut = id;
  update();
}

bool GizmoOverlay::setHover(CutHandle handle) {
  if (mHover == handle) return false;
  mHover = handle;
  update();
  return true;
}

void GizmoOverlay::setTag(QPointF pointer, const QString& text) {
  if (mTag.isEmpty() && text.isEmpty()) return;
  mPointer = pointer;
  mTag = text;
  update();
}

Qt::CursorShape GizmoOverlay::cursorFor(const session::CutGizmo& gizmo, CutHandle handle, const scene::Camera& camera,
                                        glm::dvec2 size) {
  switch (handle) {
    case CutHandle::None:
      return Qt::ArrowCursor;
    case CutHandle::Centre:
    case CutHandle::Square:
      return Qt::SizeAllCursor;
    case CutHandle::KnobRight:
    case CutHandle::KnobTop:
    case CutHandle::KnobLeft:
    case CutHandle::KnobBottom:
    case CutHandle::Ring:
      return Qt::OpenHandCursor;
    default:
      break;
  }
  for (const auto& grip : gizmo.grips)
    if (grip.handle == handle)
      return cursorAlong(Projector(camera, size).along(grip.placeMm, grip.direction, 10.0 * gizmo.pixelMm));
  return Qt::SizeAllCursor;
}

void GizmoOverlay::paintGizmo(QPainter& painter, const scene::Cut& cut) {
  const scene::Scene& scene = mDocument.scene();
  glm::dvec2 size(std::max(1, width()), std::max(1, height()));
  session::CutGizmo gizmo = session::makeCutGizmo(scene, cut, size);
  Projector project(scene.camera, size);
  if (QPainterPath outline = project.ring(gizmo.outlineMm); !outline.isEmpty()) {
    painter.fillPath(outline, withAlpha(kHandle, 14));
    strokeTwice(painter, outline, withAlpha(kHandle, 200), 1.3);
  }
  for (const auto& edge : gizmo.edgesMm)
    if (QPainterPath line = project.ring(edge); !line.isEmpty())
      strokeTwice(painter, line, withAlpha(kHandle, 130), 1.0);
  if (gizmo.hasRing)
    if (QPainterPath ring = project.ring(session::ringPointsMm(gizmo)); !ring.isEmpty())
      strokeTwice(painter, ring, mHover == CutHandle::Ring ? QColor(Qt::white) : QColor(255, 236, 210, 210), 1.6);
  auto foot = project(gizmo.centreMm), tip = project(gizmo.arrowTipMm);
  for (const auto& grip : gizmo.grips) {
    auto place = project(grip.placeMm);
    if (!place || grip.handle == CutHandle::Arrow) continue;
    bool hot = mHover == grip.handle;
    if (isResize(grip.handle))
      drawGrip(painter, *place, project.along(grip.placeMm, grip.direction, 10.0 * gizmo.pixelMm), hot);
    else if (grip.handle == CutHandle::Square)
      drawGrip(painter, *place, {1, 1}, hot);
    else
      drawKnob(painter, *place, hot);
  }
  if (foot && tip) drawArrow(painter, *foot, *tip, mHover == CutHandle::Arrow);
}

void GizmoOverlay::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (const scene::Cut* cut = scene::findCut(mDocument.scene(), mCut)) {
    painter.setOpacity(cut->enabled ? 1.0 : 0.45);
    paintGizmo(painter, *cut);
    painter.setOpacity(1.0);
  }
  drawTag(painter, mPointer, size(), mTag);
}

}  // namespace velum::gui
