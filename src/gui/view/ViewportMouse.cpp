// The pointer in the 3D view: left turns, middle or shift+left moves, right and wheel come nearer, ctrl+left rolls, and
// a click with ctrl puts the crosshair there. Tools and handles come first: the toolbox is asked.
#include <QMouseEvent>
#include <cmath>

#include "gui/kit/Points.h"
#include "gui/kit/Preferences.h"
#include "gui/view/Viewport.h"
#include "scene/Navigate.h"

namespace velum::gui {

namespace {

/// A press and a release nearer together than this are a click.
constexpr double kClickPixels = 4.0;

double angleAbout(glm::dvec2 centre, glm::dvec2 p) { return std::atan2(p.y - centre.y, p.x - centre.x); }

}  // namespace

void Viewport::beginDrag(QMouseEvent* event) {
  bool shift = event->modifiers() & Qt::ShiftModifier, control = event->modifiers() & Qt::ControlModifier;
  bool leftTurns = Preferences::habits().leftTurns;
  if (event->button() == Qt::MiddleButton)
    mDrag = leftTurns ? Drag::Pan : Drag::Orbit;
  else if (event->button() == Qt::LeftButton && shift)
    mDrag = leftTurns ? Drag::Pan : Drag::Orbit;
  else if (event->button() == Qt::RightButton)
    mDrag = Drag::Zoom;
  else if (event->button() == Qt::LeftButton)
    mDrag = control ? Drag::Roll : leftTurns ? Drag::Orbit : Drag::Pan;
}

void Viewport::mousePressEvent(QMouseEvent* event) {
  if (mDrag != Drag::None || mToolbox.press(*this, *event)) return;
  mDragStart = mDragLast = toVec(event->position());
  beginDrag(event);
}

void Viewport::dragCamera(glm::dvec2 from, glm::dvec2 to) {
  glm::dvec2 delta = (to - from) / logicalSize().y;
  scene::Camera camera = mDocument.shown().camera;
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
  if (mToolbox.drag(*this, *event)) return;
  if (mDrag != Drag::None) {
    dragCamera(mDragLast, place);
  } else {
    setCursor(mToolbox.hover(*this, mPointer).value_or(restCursor()));
    if (!mPickTimer.isActive()) mPickTimer.start();
  }
  mDragLast = place;
}

/// A button that went down and up at one place has turned nothing: it asks what is there.
void Viewport::tellClick(QMouseEvent* event, bool isRoll) {
  if (glm::length(toVec(event->position()) - mDragStart) > kClickPixels) return;
  if (mToolbox.click(*this, *event)) return;
  bool isLeft = event->button() == Qt::LeftButton;
  auto pick = pickAt(event->position());
  if (!pick) return;
  if (isRoll && pick->hit) emit placeWanted(pick->world);
  if (isLeft && event->modifiers() == Qt::NoModifier) emit clickedAt(*pick);
  if (event->button() == Qt::RightButton) emit menuAskedAt(*pick, event->globalPosition().toPoint());
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
  if (mToolbox.release(*this, *event)) return;
  if (event->buttons() != Qt::NoButton || mDrag == Drag::None) return;
  bool wasRoll = mDrag == Drag::Roll;
  mDrag = Drag::None;
  tellClick(event, wasRoll);
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
  mousePressEvent(event);
  if (mDrag != Drag::Orbit && mDrag != Drag::Pan) return;
  mDrag = Drag::None;
  if (mToolbox.click(*this, *event)) return;  // to a tool the second click is one as the first
  auto pick = pickAt(event->position());
  pick && pick->hit && pick->type >= 0 ? emit instanceWanted(*pick) : emit maximiseWanted();
}

void Viewport::wheelEvent(QWheelEvent* event) {
  if (mToolbox.wheel(*this, *event)) return event->accept();
  double notches = event->angleDelta().y() / 120.0;
  if (notches == 0.0) return;
  if (!Preferences::habits().wheelForwardComesNearer) notches = -notches;
  scene::Camera camera = scene::zoom(mDocument.shown().camera, std::pow(0.9, notches));
  mDocument.view([camera](scene::Scene& scene) { scene.camera = camera; });
  event->accept();
}

void Viewport::leaveEvent(QEvent*) {
  mPickTimer.stop();
  mToolbox.leave();
  emit pointedAtNothing();
}

}  // namespace velum::gui
