#include "gui/cut/SectionCutHandles.h"

#include <QPainterPath>
#include <utility>

#include "gui/kit/Points.h"
#include "gui/kit/Theme.h"
#include "gui/kit/Words.h"
#include "gui/service/SelectedCut.h"
#include "gui/tool/HandlePaint.h"
#include "session/extrusion/Pull.h"
#include "session/membrane/SheetHands.h"

namespace velum::gui {

namespace {

constexpr double kHandleReach = 9.0;

using session::SectionHandleKind;

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

SectionCutHandles::SectionCutHandles(session::Document& document, Selection& selection, Toolbox& toolbox,
                                     QObject* parent)
    : QObject(parent), mDocument(document), mSelection(selection), mToolbox(toolbox) {
  connect(&selection, &Selection::cutChanged, this, [this] { mToolbox.repaint(); });
}

void SectionCutHandles::setSheets(const render::SheetIndices& sheets) {
  mSheets.clear();
  for (const auto& [cut, sheet] : sheets) mSheets[cut] = sheet ? session::shapeOf(*sheet) : scene::SheetShape();
  mToolbox.repaint();
}

const scene::SheetShape& SectionCutHandles::shapeOf(const scene::Cut& cut) const {
  static const scene::SheetShape kFlat;
  if (!scene::isMembrane(cut)) return kFlat;
  auto live = mSheets.find(cut.id);
  return cut.enabled && live != mSheets.end() ? live->second : cut.membrane->shape;
}

void SectionCutHandles::paintCut(QPainter& painter, const scene::SectionPlane& plane, const scene::Cut& cut,
                                 bool isSelected) const {
  auto outline = session::sectionOutline(plane, cut, shapeOf(cut));
  QColor color = kHandle;
  color.setAlpha(!cut.enabled ? 90 : isSelected ? 255 : 150);
  double width = isSelected ? 1.6 : 1.1;
  if (!outline.curves.empty()) strokeTwice(painter, pathOf(outline.curves), color, width);
  if (scene::isMembrane(cut)) {
    if (!isSelected) return;
    QColor band = color;
    band.setAlpha(color.alpha() / 14);
    painter.fillPath(pathOf(outline.band), band);
    color.setAlpha(color.alpha() * 2 / 3);
    width = 1.0;
  }
  if (!outline.points.empty()) strokeTwice(painter, pathOf(outline.points, outline.isClosed), color, width);
}

void SectionCutHandles::paintHandles(ViewPainter& over, const scene::Cut& cut) const {
  QPainter& painter = over.painter;
  for (const auto& handle : session::sectionHandles(*over.space.section(), cut)) {
    bool hot = mView == &over.view && mHandle.kind == handle.kind && mHandle.axis == handle.axis &&
               mHandle.sign == handle.sign && (mDragging || glm::length(mHandle.place - handle.place) < 1.0);
    if (handle.kind == SectionHandleKind::Turn) {
      QPainterPath arm(toPoint(handle.pivot));
      arm.lineTo(toPoint(handle.place));
      bool isOnLine = cut.shape == scene::CutShape::Plane || scene::isMembrane(cut);
      if (!isOnLine) strokeTwice(painter, arm, QColor(255, 236, 210, 140), 1.0);
    }
    bool isGrip = handle.kind == SectionHandleKind::Face || handle.kind == SectionHandleKind::Side;
    if (isGrip)
      drawGrip(painter, toPoint(handle.place), toPoint(handle.outwards), hot);
    else if (session::isArrow(handle))
      drawArrow(painter, toPoint(handle.place), toPoint(handle.place + handle.outwards * session::kSectionArrowPixels),
                hot);
    else
      drawKnob(painter, toPoint(handle.place), hot);
  }
}

void SectionCutHandles::paint(ViewPainter& over) const {
  const scene::SectionPlane* plane = over.space.section();
  if (!plane) return;
  const scene::Cut* selected = selectedCut(mDocument, mSelection);
  for (const auto& cut : mDocument.shown().cuts) paintCut(over.painter, *plane, cut, &cut == selected);
  if (selected) {
    over.painter.setOpacity(selected->enabled ? 1.0 : 0.5);
    paintHandles(over, *selected);
    over.painter.setOpacity(1.0);
  }
  if (mView == &over.view) drawTag(over.painter, mPointer, over.size, mTag);
}

bool SectionCutHandles::press(const PointerEvent& event) {
  const scene::SectionPlane* plane = event.at.space().section();
  if (!plane || event.button != Qt::LeftButton || (event.keys & Qt::ControlModifier)) return false;
  glm::dvec2 place = event.at.pixel();
  const scene::Cut* cut = selectedCut(mDocument, mSelection);
  mHandle = cut ? session::sectionHandleAt(*plane, *cut, place, kHandleReach, shapeOf(*cut)) : session::SectionHandle{};
  for (const auto& other : mDocument.shown().cuts) {
    if (mHandle.kind != SectionHandleKind::None) break;
    auto handle = session::sectionHandleAt(*plane, other, place, 0.5 * kHandleReach, shapeOf(other));
    if (handle.kind != SectionHandleKind::Move || other.id == mSelection.cut()) continue;
    mSelection.setCut(other.id);
    mHandle = handle;
  }
  cut = selectedCut(mDocument, mSelection);
  if (mHandle.kind == SectionHandleKind::None || !cut) return false;
  mView = &event.at.view();
  mStart = *cut;
  mStartFrame = *plane;
  mFrom = place;
  mDragging = true;
  return true;
}

std::optional<Qt::CursorShape> SectionCutHandles::hover(const ViewPoint& at) {
  const scene::SectionPlane* plane = at.space().section();
  const scene::Cut* cut = selectedCut(mDocument, mSelection);
  auto before = std::exchange(mHandle, {});
  if (plane && cut) mHandle = session::sectionHandleAt(*plane, *cut, at.pixel(), kHandleReach, shapeOf(*cut));
  mView = &at.view();
  if (mHandle != before) mToolbox.repaint(at.view());
  return mHandle.kind == SectionHandleKind::None ? std::nullopt : std::optional(cursor());
}

void SectionCutHandles::drag(const PointerEvent& event) {
  mPointer = event.at.place();
  // In the section plane in which the handle was taken: a cut that is dragged must not run away when the view follows.
  scene::Cut now = session::dragSectionCut(mStart, mStartFrame, mHandle, mFrom, event.at.pixel(),
                                           session::makeCutSnap(mDocument.shown(), event.keys & Qt::ShiftModifier));
  auto like = session::likeInPicture(mHandle);
  mTag = localNumber(session::dragText(scene::lengthFormat(mDocument.shown()), mStart, now, like));
  placeCut(mDocument, now, session::dragLabel(mStart, like), true);
  mToolbox.repaint(event.at.view());
}

void SectionCutHandles::release(const PointerEvent& event) {
  mDragging = false;
  mTag.clear();
  mHandle = {};
  mDocument.endMerge();
  mToolbox.repaint(event.at.view());
}

void SectionCutHandles::leave() {
  if (mDragging || mHandle.kind == SectionHandleKind::None) return;
  mHandle = {};
  mToolbox.repaint();
}

Qt::CursorShape SectionCutHandles::cursor() const {
  switch (mHandle.kind) {
    case SectionHandleKind::None:
      return Qt::ArrowCursor;
    case SectionHandleKind::Turn:
      return mDragging ? Qt::ClosedHandCursor : Qt::OpenHandCursor;
    case SectionHandleKind::Move:
      if (mHandle.outwards == glm::dvec2(0.0)) return Qt::SizeAllCursor;
      break;
    default:
      break;
  }
  return cursorAlong(toPoint(mHandle.outwards));
}

}  // namespace velum::gui
