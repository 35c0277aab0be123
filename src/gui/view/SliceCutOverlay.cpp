#include "SliceCutOverlay.h"

#include <QPainterPath>

#include "GizmoPaint.h"
#include "kit/Theme.h"
#include "velum/session/membrane/SheetHands.h"

namespace velum::gui {

namespace {

constexpr double kReachPixels = 9.0;

using session::SliceHandleKind;

glm::dvec2 toVec(QPointF p) { return {p.x(), p.y()}; }
QPointF toPoint(glm::dvec2 p) { return {p.x, p.y}; }

QPainterPath pathOf(const std::vector<glm::dvec2>& points, bool isClosed = true) {
  QPolygonF polygon;
  for (const auto& p : points) polygon << toPoint(p);
  QPainterPath path;
  path.addPolygon(polygon);
  if (isClosed) path.closeSubpath();
  return path;
}

QPainterPath pathOf(const std::vector<std::vector<glm::dvec2>>& curves) {
  QPainterPath path;
  for (const auto& curve : curves) {
    QPolygonF polygon;
    for (const auto& p : curve) polygon << toPoint(p);
    path.addPolygon(polygon);
  }
  return path;
}

}  // namespace

SliceCutOverlay::SliceCutOverlay(session::Document& document, Selection& selection)
    : mDocument(document), mSelection(selection) {}

const scene::Cut* SliceCutOverlay::selected() const { return scene::findCut(mDocument.scene(), mSelection.cut()); }

void SliceCutOverlay::setSheets(const render::SheetIndices& sheets) {
  mSheets.clear();
  for (const auto& [cut, sheet] : sheets) mSheets[cut] = sheet ? session::shapeOf(*sheet) : scene::SheetShape();
}

const scene::SheetShape& SliceCutOverlay::shapeOf(const scene::Cut& cut) const {
  static const scene::SheetShape kFlat;
  if (!scene::isMembrane(cut)) return kFlat;
  auto live = mSheets.find(cut.id);
  return cut.enabled && live != mSheets.end() ? live->second : cut.membrane->shape;
}

void SliceCutOverlay::paintCut(QPainter& painter, const scene::SliceFrame& frame, const scene::Cut& cut,
                               bool isSelected) const {
  auto outline = session::sliceOutline(frame, cut, shapeOf(cut));
  QColor color = kHandle;
  color.setAlpha(!cut.enabled ? 90 : isSelected ? 255 : 150);
  double width = isSelected ? 1.6 : 1.1;
  if (scene::isMembrane(cut)) {
    strokeTwice(painter, pathOf(outline.curves), color, width);
    if (!isSelected) return;
    QColor band = color;
    band.setAlpha(color.alpha() / 14);
    painter.fillPath(pathOf(outline.band), band);
    color.setAlpha(color.alpha() * 2 / 3);
    width = 1.0;
  }
  if (!outline.points.empty()) strokeTwice(painter, pathOf(outline.points, outline.isClosed), color, width);
}

void SliceCutOverlay::paintHandles(QPainter& painter, const scene::SliceFrame& frame, const scene::Cut& cut) const {
  for (const auto& handle : session::sliceHandles(frame, cut)) {
    bool hot = mHandle.kind == handle.kind && mHandle.axis == handle.axis && mHandle.sign == handle.sign &&
               (mDragging || glm::length(mHandle.place - handle.place) < 1.0);
    if (handle.kind == SliceHandleKind::Turn) {
      QPainterPath arm(toPoint(handle.pivot));
      arm.lineTo(toPoint(handle.place));
      bool isOnLine = cut.shape == scene::CutShape::Plane || cut.shape == scene::CutShape::Membrane;
      if (!isOnLine) strokeTwice(painter, arm, QColor(255, 236, 210, 140), 1.0);
    }
    bool isGrip = handle.kind == SliceHandleKind::Face || handle.kind == SliceHandleKind::Side;
    if (isGrip)
      drawGrip(painter, toPoint(handle.place), toPoint(handle.outwards), hot);
    else if (session::isArrow(handle))
      drawArrow(painter, toPoint(handle.place), toPoint(handle.place + handle.outwards * session::kSliceArrowPixels),
                hot);
    else
      drawKnob(painter, toPoint(handle.place), hot);
  }
}

void SliceCutOverlay::paint(QPainter& painter, const scene::SliceFrame& frame) const {
  const auto& cuts = mDocument.scene().cuts;
  if (!mDocument.scene().slices.showCuts) return;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setClipRect(QRectF(0, 0, frame.size.x, frame.size.y));
  for (const auto& cut : cuts) paintCut(painter, frame, cut, &cut == selected());
  if (const scene::Cut* cut = selected()) {
    painter.setOpacity(cut->enabled ? 1.0 : 0.5);
    paintHandles(painter, frame, *cut);
    painter.setOpacity(1.0);
  }
  drawTag(painter, mPointer, QSize(int(frame.size.x), int(frame.size.y)), mTag);
  painter.restore();
}

bool SliceCutOverlay::press(QPointF place, const scene::SliceFrame& frame) {
  const auto& scene = mDocument.scene();
  if (!scene.slices.showCuts) return false;
  const scene::Cut* cut = selected();
  mHandle =
      cut ? session::sliceHandleAt(frame, *cut, toVec(place), kReachPixels, shapeOf(*cut)) : session::SliceHandle{};
  if (mHandle.kind == SliceHandleKind::None) {
    for (const auto& other : scene.cuts)
      if (auto handle = session::sliceHandleAt(frame, other, toVec(place), 0.5 * kReachPixels, shapeOf(other));
          handle.kind == SliceHandleKind::Move && other.id != mSelection.cut()) {
        mSelection.setCut(other.id);
        mHandle = handle;
        break;
      }
    cut = selected();
  }
  if (mHandle.kind == SliceHandleKind::None || !cut) return false;
  mStart = *cut;
  mStartFrame = frame;
  mFrom = toVec(place);
  mDragging = true;
  return true;
}

bool SliceCutOverlay::move(QPointF place, const scene::SliceFrame& frame, bool snap) {
  mPointer = place;
  const scene::Cut* cut = selected();
  if (!mDragging) {
    bool shown = cut && mDocument.scene().slices.showCuts;
    mHandle =
        shown ? session::sliceHandleAt(frame, *cut, toVec(place), kReachPixels, shapeOf(*cut)) : session::SliceHandle{};
    return mHandle.kind != SliceHandleKind::None;
  }
  if (!cut) return true;
  // By the frame in which it was taken: a cut that is dragged must not run away when the view follows.
  scene::Cut now = session::dragSliceCut(mStart, mStartFrame, mHandle, mFrom, toVec(place),
                                         session::makeCutSnap(mDocument.scene(), snap));
  auto like = session::likeInPicture(mHandle);
  mTag = QString::fromStdString(session::dragText(mStart, now, like));
  mDocument.edit(
      session::dragLabel(mStart, like), [&](scene::Scene& scene) { session::replaceCut(scene, std::move(now)); }, true);
  return true;
}

bool SliceCutOverlay::release() {
  if (!mDragging) return false;
  mDragging = false;
  mTag.clear();
  mHandle = {};
  mDocument.endMerge();
  return true;
}

void SliceCutOverlay::leave() {
  if (!mDragging) mHandle = {};
}

Qt::CursorShape SliceCutOverlay::cursor() const {
  switch (mHandle.kind) {
    case SliceHandleKind::None:
      return Qt::ArrowCursor;
    case SliceHandleKind::Turn:
      return mDragging ? Qt::ClosedHandCursor : Qt::OpenHandCursor;
    case SliceHandleKind::Move:
      if (mHandle.outwards == glm::dvec2(0.0)) return Qt::SizeAllCursor;
      break;
    default:
      break;
  }
  return cursorAlong(toPoint(mHandle.outwards));
}

}  // namespace velum::gui
