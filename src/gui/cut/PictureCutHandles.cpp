#include "gui/cut/PictureCutHandles.h"

#include <QPainterPath>
#include <utility>

#include "gui/kit/Theme.h"
#include "gui/kit/Words.h"
#include "gui/service/SelectedCut.h"
#include "gui/tool/HandlePaint.h"
#include "session/extrusion/Pull.h"

namespace velum::gui {

namespace {

constexpr double kReachPixels = 9.0;

using session::CutHandle;
using session::ViewSpace;

std::optional<QPointF> pointOf(const ViewSpace& view, glm::dvec3 world) {
  auto pixel = view.pixelFromWorld(world);
  if (!pixel) return std::nullopt;
  return QPointF(pixel->x, pixel->y);
}

/// A closed line; empty when a part of it lies behind the eye.
QPainterPath ringOf(const ViewSpace& view, const std::vector<glm::dvec3>& points) {
  QPolygonF polygon;
  for (const auto& p : points) {
    auto place = pointOf(view, p);
    if (!place) return {};
    polygon << *place;
  }
  QPainterPath path;
  path.addPolygon(polygon);
  path.closeSubpath();
  return path;
}

/// Screen direction of a world direction at a place.
QPointF wayOf(const ViewSpace& view, glm::dvec3 place, glm::dvec3 direction, double length) {
  auto a = pointOf(view, place), b = pointOf(view, place + direction * length);
  return a && b ? *b - *a : QPointF(1, 0);
}

QColor withAlpha(QColor color, int alpha) {
  color.setAlpha(alpha);
  return color;
}

bool isResize(CutHandle handle) { return handle >= CutHandle::FaceXMin; }
bool isTurn(CutHandle handle) { return handle >= CutHandle::KnobRight && handle <= CutHandle::Ring; }

/// The cursor that says how a handle goes.
Qt::CursorShape cursorFor(const session::CutGizmo& gizmo, CutHandle handle, const ViewSpace& view) {
  if (isTurn(handle)) return Qt::OpenHandCursor;
  if (handle != CutHandle::Centre && handle != CutHandle::Square)
    for (const auto& grip : gizmo.grips)
      if (grip.handle == handle) return cursorAlong(wayOf(view, grip.place, grip.direction, 10.0 * gizmo.pixel));
  return Qt::SizeAllCursor;
}

void paintGizmo(QPainter& painter, const session::CutGizmo& gizmo, const ViewSpace& view, CutHandle hover) {
  if (gizmo.grips.empty()) return;
  if (QPainterPath outline = ringOf(view, gizmo.outline); !outline.isEmpty()) {
    painter.fillPath(outline, withAlpha(kHandle, 14));
    strokeTwice(painter, outline, withAlpha(kHandle, 200), 1.3);
  }
  for (const auto& edge : gizmo.edges)
    if (QPainterPath line = ringOf(view, edge); !line.isEmpty())
      strokeTwice(painter, line, withAlpha(kHandle, 130), 1.0);
  if (gizmo.hasRing)
    if (QPainterPath ring = ringOf(view, session::ringPoints(gizmo)); !ring.isEmpty())
      strokeTwice(painter, ring, hover == CutHandle::Ring ? QColor(Qt::white) : QColor(255, 236, 210, 210), 1.6);
  for (const auto& grip : gizmo.grips) {
    auto place = pointOf(view, grip.place);
    if (!place || grip.handle == CutHandle::Arrow) continue;
    bool hot = hover == grip.handle;
    if (isResize(grip.handle))
      drawGrip(painter, *place, wayOf(view, grip.place, grip.direction, 10.0 * gizmo.pixel), hot);
    else if (grip.handle == CutHandle::Square)
      drawGrip(painter, *place, {1, 1}, hot);
    else
      drawKnob(painter, *place, hot);
  }
  auto foot = pointOf(view, gizmo.centre), tip = pointOf(view, gizmo.arrowTip);
  if (foot && tip) drawArrow(painter, *foot, *tip, hover == CutHandle::Arrow);
}

}  // namespace

PictureCutHandles::PictureCutHandles(session::Document& document, Selection& selection, Toolbox& toolbox,
                                     QObject* parent)
    : QObject(parent), mDocument(document), mSelection(selection), mToolbox(toolbox) {
  connect(&selection, &Selection::cutChanged, this, [this] { mToolbox.repaint(); });
}

CutHandle PictureCutHandles::handleUnder(const ViewPoint& at) const {
  const scene::Cut* cut = selectedCut(mDocument, mSelection);
  if (!cut || at.isOnSection()) return CutHandle::None;
  const ViewSpace& view = at.space();
  return session::handleAt(session::makeCutGizmo(mDocument.shown(), *cut, view.size()), view.camera(), view.size(),
                           at.pixel(), kReachPixels);
}

/// Shift belongs to the handle: it keeps to steps.
bool PictureCutHandles::press(const PointerEvent& event) {
  bool plain = event.keys == Qt::NoModifier || event.keys == Qt::ShiftModifier;
  if (event.button != Qt::LeftButton || !plain) return false;
  CutHandle handle = handleUnder(event.at);
  if (handle == CutHandle::None) return false;
  mHandle = handle;
  mStart = *selectedCut(mDocument, mSelection);
  mStartGizmo = session::makeCutGizmo(mDocument.shown(), mStart, event.at.space().size());
  mFrom = event.at.pixel();
  if (isTurn(handle)) event.at.view().widget().setCursor(Qt::ClosedHandCursor);
  setHover(handle);
  return true;
}

void PictureCutHandles::drag(const PointerEvent& event) {
  const ViewSpace& view = event.at.space();
  scene::Cut moved = session::dragCut(mStart, mStartGizmo, mHandle, view.camera(), view.size(), mFrom, event.at.pixel(),
                                      session::makeCutSnap(mDocument.shown(), event.keys & Qt::ShiftModifier));
  mPointer = event.at.place();
  mTag = localNumber(session::dragText(scene::lengthFormat(mDocument.shown()), mStart, moved, mHandle));
  placeCut(mDocument, moved, session::dragLabel(mStart, mHandle), true);
  mToolbox.repaint(event.at.view());
}

void PictureCutHandles::release(const PointerEvent& event) {
  mDocument.endMerge();
  mHandle = CutHandle::None;
  mTag.clear();
  event.at.view().widget().setCursor(event.at.view().restCursor());
  setHover(CutHandle::None);
  mToolbox.repaint(event.at.view());
}

std::optional<Qt::CursorShape> PictureCutHandles::hover(const ViewPoint& at) {
  CutHandle handle = handleUnder(at);
  setHover(handle);
  if (handle == CutHandle::None) return std::nullopt;
  return cursorFor(session::makeCutGizmo(mDocument.shown(), *selectedCut(mDocument, mSelection), at.space().size()),
                   handle, at.space());
}

void PictureCutHandles::setHover(CutHandle handle) {
  if (std::exchange(mHover, handle) != handle) mToolbox.repaint();
}

void PictureCutHandles::paint(ViewPainter& over) const {
  const scene::Cut* cut = selectedCut(mDocument, mSelection);
  if (over.space.section() || !cut) return;
  over.painter.setOpacity(cut->enabled ? 1.0 : 0.45);
  paintGizmo(over.painter, session::makeCutGizmo(mDocument.shown(), *cut, over.space.size()), over.space, mHover);
  over.painter.setOpacity(1.0);
  drawTag(over.painter, mPointer, over.size, mTag);
}

}  // namespace velum::gui
