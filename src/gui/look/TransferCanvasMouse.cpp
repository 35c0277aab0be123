// The hand on a transfer function: a drag says at each move what the function would become, from what it was when the
// drag began.
#include <QMouseEvent>
#include <algorithm>
#include <cmath>

#include "gui/look/TransferCanvas.h"

#include "scene/Scene.h"

namespace velum::gui {

namespace {

constexpr double kReach = 7.0;          // pixels; as far as a fingertip is off
constexpr double kStillPixels = 3.0;    // a hand that clicks moves less
constexpr double kStretchPixels = 120;  // of a drag that doubles the width

}  // namespace

session::Curve& TransferCanvas::curveOf(scene::TransferFunction& transfer) const {
  return hasColors() ? transfer.opacities : transfer.gradientOpacities;
}

session::CurveHit TransferCanvas::hitAt(QPointF place) const {
  return session::hitCurve(frame(), curve(), {place.x(), place.y()}, kReach);
}

/// The stop whose pin or place in the bar is under the pointer; -1: none.
int TransferCanvas::stopAt(QPointF place) const {
  return session::hitStop(frame(), mTransfer.colors, place.x(), kReach);
}

void TransferCanvas::mousePressEvent(QMouseEvent* event) {
  if (mDrag != Drag::None) return;
  mStartPlace = event->position();
  mStart = mTransfer;
  mStartView = view();
  mJustAdded = false;
  bool onAxis = axisRect().contains(mStartPlace);
  bool onColors = hasColors() && !onAxis && mStartPlace.y() >= barRect().top() - 2;
  if (event->button() == Qt::MiddleButton || (onAxis && event->button() == Qt::LeftButton)) {
    mDrag = Drag::Axis;
    setCursor(Qt::ClosedHandCursor);
  } else if (event->button() == Qt::RightButton) {
    removeAt(mStartPlace);
  } else if (event->button() == Qt::LeftButton) {
    onColors ? pressColors(mStartPlace) : beginDrag(mStartPlace, event->modifiers());
  }
}

void TransferCanvas::beginDrag(QPointF place, Qt::KeyboardModifiers keys) {
  if (curve().empty()) return;
  session::CurveHit hit = hitAt(place);
  if (keys & Qt::ShiftModifier) {
    mDrag = Drag::Shift;
  } else if (keys & Qt::AltModifier) {
    mDrag = Drag::Stretch;
  } else if (hit.part == session::CurveHit::Part::Point) {
    select({Selection::Part::Point, hit.index});
    mDrag = Drag::Point;
  } else {
    if (hit.part == session::CurveHit::Part::Line) mDrag = Drag::Line;
    if (hit.part == session::CurveHit::Part::Area) mDrag = Drag::Area;
    if (mDrag != Drag::Line) select({});
  }
}

void TransferCanvas::pressColors(QPointF place) {
  int index = stopAt(place);
  if (index < 0) {
    scene::TransferFunction next = mTransfer;
    index = session::addStop(next.colors, session::valueAtX(frame(), place.x()));
    mStopLabel = tr("Add colour");  // moving it at once belongs to adding it
    emit edited(mStopLabel, next, true);
    mStart = next;
  } else {
    mStopLabel = tr("Move colour");
  }
  select({Selection::Part::Stop, index});
  mDrag = Drag::Stop;
}

void TransferCanvas::mouseMoveEvent(QMouseEvent* event) {
  setHover(event->position());
  if (mDrag == Drag::None)
    chooseCursor(event->position(), event->modifiers());
  else
    dragTo(event->position());
  update();
}

void TransferCanvas::chooseCursor(QPointF place, Qt::KeyboardModifiers keys) {
  session::CurveHit::Part part = hitAt(place).part;
  bool onAxis = axisRect().contains(place);
  bool onColors = hasColors() && !onAxis && place.y() >= barRect().top() - 2;
  if (onAxis)
    setCursor(Qt::OpenHandCursor);
  else if (onColors)
    setCursor(stopAt(place) >= 0 ? Qt::SizeHorCursor : Qt::CrossCursor);
  else if (keys & (Qt::ShiftModifier | Qt::AltModifier))
    setCursor(Qt::SizeHorCursor);
  else if (part == session::CurveHit::Part::Point)
    setCursor(Qt::SizeAllCursor);
  else
    setCursor(part == session::CurveHit::Part::Line ? Qt::CrossCursor : Qt::ArrowCursor);
}

void TransferCanvas::dragTo(QPointF place) {
  session::CurveFrame f = frame();
  QPointF away = place - mStartPlace;
  if (mDrag == Drag::Axis) {
    double perPixel = (mStartView.high - mStartView.low) / f.size.x;
    setView(session::panAxis(mStartView, -away.x() * perPixel, mWhole));
    emit viewChanged();
    return;
  }
  // A drag between points takes the direction in which it begins.
  if (mDrag == Drag::Line || mDrag == Drag::Area) {
    if (std::hypot(away.x(), away.y()) < kStillPixels) return;
    mDrag = std::abs(away.x()) >= std::abs(away.y()) ? Drag::Shift : Drag::Scale;
    select({});
    setCursor(mDrag == Drag::Shift ? Qt::SizeHorCursor : Qt::SizeVerCursor);
  }
  scene::TransferFunction next = mStart;
  if (mDrag == Drag::Point) {
    // Relative to where the point was, so that a point that is pressed beside its middle does not jump.
    const auto& point = curveOf(mStart)[std::size_t(mSelection.index)];
    session::movePoint(curveOf(next), mSelection.index, session::valueAtX(f, session::xOf(f, point.value) + away.x()),
                       session::opacityAtY(f, session::yOf(f, point.opacity) + away.y()));
    emit edited(named("Move"), next, true);
  } else if (mDrag == Drag::Stop) {
    double x = session::xOf(f, mStart.colors[std::size_t(mSelection.index)].value) + away.x();
    session::moveStop(next.colors, mSelection.index, session::valueAtX(f, x));
    emit edited(mStopLabel, next, true);
  } else {
    dragWhole(place);
  }
}

void TransferCanvas::dragWhole(QPointF place) {
  session::CurveFrame f = frame();
  scene::TransferFunction next = mStart;
  // A drag of the gradient curve moves only the values of that curve.
  scene::TransferFunction part;
  scene::TransferFunction& target = hasColors() ? next : part;
  if (!hasColors()) part.opacities = mStart.gradientOpacities;
  QString label;
  if (mDrag == Drag::Shift) {
    session::shiftTransfer(target, session::valueAtX(f, place.x()) - session::valueAtX(f, mStartPlace.x()));
    label = tr("Shift transfer function");
  } else if (mDrag == Drag::Stretch) {
    session::stretchTransfer(target, session::middleOf(target),
                             std::exp2((place.x() - mStartPlace.x()) / kStretchPixels));
    label = tr("Stretch transfer function");
  } else {
    double from = std::max(session::opacityAtY(f, mStartPlace.y()), 1e-3);
    // Never down to zero, from where no factor leads back.
    session::scaleOpacity(target, std::max(session::opacityAtY(f, place.y()) / from, 0.01));
    label = tr("Scale opacity");
  }
  if (!hasColors()) next.gradientOpacities = part.opacities;
  emit edited(label, next, true);
}

void TransferCanvas::mouseReleaseEvent(QMouseEvent* event) {
  if (event->buttons() != Qt::NoButton) return;
  Drag drag = mDrag;
  mDrag = Drag::None;
  if (drag == Drag::Line) addPointAt(mStartPlace);
  if (drag != Drag::None && drag != Drag::Axis) emit settled();
  chooseCursor(event->position(), event->modifiers());
}

void TransferCanvas::addPointAt(QPointF place) {
  session::CurveFrame f = frame();
  scene::TransferFunction next = mTransfer;
  double value = session::valueAtX(f, place.x());
  bool isOnLine = hitAt(place).part == session::CurveHit::Part::Line;
  double opacity = isOnLine ? scene::opacityAt(curve(), value) : session::opacityAtY(f, place.y());
  int index = session::addPoint(curveOf(next), value, opacity);
  emit edited(named("Add"), next, false);
  select({Selection::Part::Point, index});
  mJustAdded = true;
}

void TransferCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
  QPointF place = event->position();
  if (event->button() != Qt::LeftButton) return mousePressEvent(event);
  if (axisRect().contains(place)) {
    setView(mWhole);
    emit viewChanged();
  } else if (hasColors() && place.y() >= barRect().top() - 2) {
    if (stopAt(place) < 0) return;
    select({Selection::Part::Stop, stopAt(place)});
    emit colorWanted();
  } else if (hitAt(place).part == session::CurveHit::Part::Point) {
    if (!mJustAdded) removeAt(place);
  } else if (!curve().empty()) {
    addPointAt(place);
    emit settled();
  }
}

void TransferCanvas::removeAt(QPointF place) {
  bool onColors = hasColors() && place.y() >= barRect().top() - 2;
  int index = onColors ? stopAt(place) : hitAt(place).index;
  if (index < 0) return;
  select({onColors ? Selection::Part::Stop : Selection::Part::Point, index});
  removeSelected();
}

void TransferCanvas::wheelEvent(QWheelEvent* event) {
  double notches = event->angleDelta().y() / 120.0;
  if (notches != 0.0) zoom(session::valueAtX(frame(), event->position().x()), std::pow(0.8, notches));
  event->accept();
}

}  // namespace velum::gui
