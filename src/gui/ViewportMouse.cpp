// The pointer in the 3D view: left turns, middle or shift+left moves, right and wheel come nearer, ctrl+left rolls; the
// handles of the selected cut come first.
#include <QMouseEvent>
#include <cmath>

#include "GizmoOverlay.h"
#include "Viewport.h"
#include "velum/scene/Navigate.h"

namespace velum::gui {

namespace {

constexpr double kReachPixels = 9.0;
constexpr double kStillPixels = 3.0;  // a hand that clicks moves less

glm::dvec2 toVec(QPointF p) { return {p.x(), p.y()}; }

double angleAbout(glm::dvec2 centre, glm::dvec2 p) { return std::atan2(p.y - centre.y, p.x - centre.x); }

}  // namespace

void Viewport::setHover(session::CutHandle handle) {
  mOverlay->setHover(handle);
  if (mDrag == Drag::None) setCursor(handle == session::CutHandle::None ? restCursor() : Qt::OpenHandCursor);
}

Qt::CursorShape Viewport::restCursor() const { return mPointing ? Qt::CrossCursor : Qt::ArrowCursor; }

void Viewport::setPointing(bool pointing) {
  mPointing = pointing;
  setCursor(restCursor());
}

void Viewport::beginDrag(QMouseEvent* event) {
  bool shift = event->modifiers() & Qt::ShiftModifier, control = event->modifiers() & Qt::ControlModifier;
  if (event->button() == Qt::MiddleButton || (event->button() == Qt::LeftButton && shift))
    mDrag = Drag::Pan;
  else if (event->button() == Qt::RightButton)
    mDrag = Drag::Zoom;
  else if (event->button() == Qt::LeftButton)
    mDrag = control ? Drag::Roll : Drag::Orbit;
}

void Viewport::mousePressEvent(QMouseEvent* event) {
  if (mDrag != Drag::None) return;
  mDragStart = mDragLast = toVec(event->position());
  const scene::Cut* selected = cut();
  if (event->button() == Qt::LeftButton && event->modifiers() == Qt::NoModifier && selected) {
    mStartGizmo = session::makeCutGizmo(mDocument.scene(), *selected, logicalSize());
    mHandle = session::handleAt(mStartGizmo, mDocument.scene().camera, logicalSize(), mDragStart, kReachPixels);
    if (mHandle != session::CutHandle::None) {
      mStartCut = *selected;
      mDrag = Drag::Cut;
      setCursor(Qt::ClosedHandCursor);
      mOverlay->setHover(mHandle);
      return;
    }
  }
  beginDrag(event);
}

void Viewport::dragCamera(glm::dvec2 from, glm::dvec2 to) {
  glm::dvec2 delta = (to - from) / logicalSize().y;
  scene::Camera camera = mDocument.scene().camera;
  if (mDrag == Drag::Orbit) camera = scene::orbit(camera, delta);
  if (mDrag == Drag::Pan) camera = scene::pan(camera, delta);
  if (mDrag == Drag::Zoom) camera = scene::zoom(camera, std::exp(2.0 * delta.y));
  glm::dvec2 centre = logicalSize() * 0.5;
  if (mDrag == Drag::Roll) camera = scene::roll(camera, angleAbout(centre, to) - angleAbout(centre, from));
  mDocument.view([camera](scene::Scene& scene) { scene.camera = camera; });
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
  glm::dvec2 place = toVec(event->position());
  mPointer = event->position();
  if (mDrag == Drag::Cut) {
    scene::Cut moved =
        session::dragCut(mStartCut, mStartGizmo, mHandle, mDocument.scene().camera, logicalSize(), mDragStart, place);
    const char* label = mHandle == session::CutHandle::Arrow ? "Move cut" : "Tilt cut";
    std::size_t index = std::size_t(mSelectedCut);
    mDocument.edit(
        label,
        [&](scene::Scene& scene) {
          if (index < scene.cuts.size()) scene.cuts[index] = moved;
        },
        true);
  } else if (mDrag != Drag::None) {
    dragCamera(mDragLast, place);
  } else {
    if (const scene::Cut* selected = cut()) {
      auto gizmo = session::makeCutGizmo(mDocument.scene(), *selected, logicalSize());
      setHover(session::handleAt(gizmo, mDocument.scene().camera, logicalSize(), place, kReachPixels));
    }
    if (!mPickTimer.isActive()) mPickTimer.start();
  }
  mDragLast = place;
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
  if (event->buttons() != Qt::NoButton || mDrag == Drag::None) return;
  if (mDrag == Drag::Cut) mDocument.endMerge();
  bool isClick = mDrag != Drag::Cut && glm::length(toVec(event->position()) - mDragStart) < kStillPixels;
  mDrag = Drag::None;
  mHandle = session::CutHandle::None;
  setCursor(restCursor());
  mOverlay->setHover(session::CutHandle::None);
  if (isClick && event->button() == Qt::LeftButton) emit clicked(event->position(), event->modifiers());
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) { mousePressEvent(event); }

void Viewport::wheelEvent(QWheelEvent* event) {
  double notches = event->angleDelta().y() / 120.0;
  if (notches == 0.0) return;
  scene::Camera camera = scene::zoom(mDocument.scene().camera, std::pow(0.9, notches));
  mDocument.view([camera](scene::Scene& scene) { scene.camera = camera; });
  event->accept();
}

void Viewport::leaveEvent(QEvent*) {
  mPickTimer.stop();
  setHover(session::CutHandle::None);
  emit pointedAtNothing();
}

}  // namespace velum::gui
