// The pointer in the 3D view: left turns, middle or shift+left moves, right and wheel come nearer, ctrl+left rolls, and
// a click with ctrl puts the crosshair there; the handles of the selected cut come first.
#include <QMouseEvent>
#include <cmath>

#include "GizmoOverlay.h"
#include "Viewport.h"
#include "velum/scene/Navigate.h"

namespace velum::gui {

namespace {

constexpr double kReachPixels = 9.0;
/// A press and a release nearer together than this are a click.
constexpr double kClickPixels = 4.0;

glm::dvec2 toVec(QPointF p) { return {p.x(), p.y()}; }

double angleAbout(glm::dvec2 centre, glm::dvec2 p) { return std::atan2(p.y - centre.y, p.x - centre.x); }

}  // namespace

void Viewport::setHover(session::CutHandle handle) {
  bool left = mOverlay->setHover(handle) && handle == session::CutHandle::None;
  if (mDrag != Drag::None) return;
  const scene::Cut* selected = cut();
  if (handle != session::CutHandle::None && selected)
    setCursor(GizmoOverlay::cursorFor(session::makeCutGizmo(mDocument.scene(), *selected, logicalSize()), handle,
                                      mDocument.scene().camera, logicalSize()));
  else if (left)
    setCursor(restCursor());
}

Qt::CursorShape Viewport::restCursor() const { return mPointing ? Qt::CrossCursor : Qt::ArrowCursor; }

void Viewport::setPointing(bool pointing) {
  mPointing = pointing;
  setCursor(restCursor());
}

/// True when the press was on a handle of the selected cut. Shift belongs to the handle: it keeps to steps.
bool Viewport::takeHandle(QMouseEvent* event) {
  const scene::Cut* selected = cut();
  bool plain = event->modifiers() == Qt::NoModifier || event->modifiers() == Qt::ShiftModifier;
  if (event->button() != Qt::LeftButton || !plain || !selected) return false;
  mStartGizmo = session::makeCutGizmo(mDocument.scene(), *selected, logicalSize());
  mHandle = session::handleAt(mStartGizmo, mDocument.scene().camera, logicalSize(), mDragStart, kReachPixels);
  if (mHandle == session::CutHandle::None) return false;
  mStartCut = *selected;
  mDrag = Drag::Cut;
  if (mHandle >= session::CutHandle::KnobRight && mHandle <= session::CutHandle::Ring) setCursor(Qt::ClosedHandCursor);
  mOverlay->setHover(mHandle);
  return true;
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
  if (!takeHandle(event)) beginDrag(event);
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

void Viewport::dragSelectedCut(glm::dvec2 place, bool snap) {
  scene::Cut moved = session::dragCut(mStartCut, mStartGizmo, mHandle, mDocument.scene().camera, logicalSize(),
                                      mDragStart, place, session::makeCutSnap(mDocument.scene(), snap));
  mOverlay->setTag(mPointer, QString::fromStdString(session::dragText(mStartCut, moved, mHandle)));
  mDocument.edit(
      session::dragLabel(mStartCut, mHandle),
      [&](scene::Scene& scene) { session::replaceCut(scene, std::move(moved)); }, true);
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
  glm::dvec2 place = toVec(event->position());
  mPointer = event->position();
  if (mDrag == Drag::Cut) {
    dragSelectedCut(place, event->modifiers() & Qt::ShiftModifier);
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

/// A button that went down and up at one place has turned nothing: it asks what is there.
void Viewport::tellClick(QMouseEvent* event, bool isRoll) {
  if (glm::length(toVec(event->position()) - mDragStart) > kClickPixels) return;
  bool isLeft = event->button() == Qt::LeftButton;
  // While a tool points, clicks are its own.
  if (mPointing && isLeft) {
    emit clicked(event->position(), event->modifiers());
    return;
  }
  auto pick = pickAt(event->position());
  if (!pick) return;
  if (isRoll && pick->hit) emit placeWanted(pick->worldMm);
  if (isLeft && event->modifiers() == Qt::NoModifier) emit clickedAt(*pick);
  if (event->button() == Qt::RightButton) emit menuAskedAt(*pick, event->globalPosition().toPoint());
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
  if (event->buttons() != Qt::NoButton || mDrag == Drag::None) return;
  bool wasCut = mDrag == Drag::Cut, wasRoll = mDrag == Drag::Roll;
  if (wasCut) mDocument.endMerge();
  mDrag = Drag::None;
  mHandle = session::CutHandle::None;
  mOverlay->setTag({}, {});
  if (wasCut) {
    setCursor(restCursor());
    mOverlay->setHover(session::CutHandle::None);
  } else {
    tellClick(event, wasRoll);
  }
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
  mousePressEvent(event);
  if (mDrag != Drag::Orbit) return;
  mDrag = Drag::None;
  emit maximiseWanted();
}

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
