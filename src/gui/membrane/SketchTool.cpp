#include "SketchTool.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QLineEdit>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "SketchOverlay.h"
#include "velum/scene/Project.h"
#include "velum/session/cut/CutTool.h"
#include "velum/session/membrane/Sketch.h"
#include "velum/session/membrane/StrokeSamples.h"

namespace velum::gui {

namespace {

constexpr double kRadiusStep = 1.15;
constexpr double kFirstShare = 0.02;    // radius of the first brush, of the data's
constexpr double kPathStep = 0.2;       // between points of a path that is being drawn, in radii
constexpr double kPathTolerance = 0.1;  // of the path that is kept, in radii
constexpr double kHandlePixels = 9.0;   // as in the 3D view

glm::dvec2 toVec(QPointF p) { return {p.x(), p.y()}; }

/// Two digits are enough for a brush.
double rounded(double mm) {
  double unit = std::pow(10.0, std::floor(std::log10(std::max(mm, 1e-9))) - 1.0);
  return std::round(mm / unit) * unit;
}

}  // namespace

SketchTool::SketchTool(session::Document& document, ViewGrid& views, Selection& selection, MessageBar& messages,
                       QObject* parent)
    : QObject(parent), mDocument(document), mViews(views), mSelection(selection), mMessages(messages) {
  for (int i = 0; i < 3; ++i)
    mOverlays[std::size_t(i)] = new SketchOverlay(*this, views.slice(static_cast<scene::SliceKind>(i)));
  mOverlays[3] = new SketchOverlay(*this, views.viewport());
  connect(&selection, &Selection::cutChanged, this, [this] {
    stop();
    select(-1);
    refresh();
  });
}

const std::vector<scene::Stroke>* SketchTool::strokes() const {
  const scene::Cut* cut = scene::findCut(mDocument.scene(), mSelection.cut());
  return cut && scene::isMembrane(*cut) ? &cut->membrane->field.strokes : nullptr;
}

void SketchTool::refresh() {
  const auto& volume = mDocument.scene().volume.data;
  if (volume && mFitted != volume.id()) {
    mFitted = volume.id();
    mRadiusMm = rounded(kFirstShare * velum::radiusMm(*volume));
    emit radiusChanged(mRadiusMm);
  }
  const Strokes* all = strokes();
  if (mSelected >= 0 && (!all || mSelected >= int(all->size()))) select(-1);
  if (mActive && (!all || !volume)) stop();
  updateOverlays();
}

void SketchTool::updateOverlays() {
  const Strokes* all = strokes();
  bool isSeen = mActive || (all && !all->empty());
  for (auto* overlay : mOverlays) {
    overlay->setVisible(isSeen);
    if (isSeen) overlay->update();
  }
}

void SketchTool::start(bool avoid) {
  if (!strokes() || !mDocument.scene().volume.data) return emit ended();
  mAvoid = avoid;
  select(-1);
  mActive = true;
  mViews.viewport().setPointing(true);
  listen();
  updateOverlays();
}

/// To keys while there is a brush or a marked stroke, and to the views while there is a brush.
void SketchTool::listen() {
  qApp->removeEventFilter(this);
  if (mActive || mSelected >= 0) qApp->installEventFilter(this);
}

void SketchTool::stop() {
  if (!mActive) return;
  mActive = false;
  mDraft.reset();
  mDrawsIn = nullptr;
  listen();
  mViews.viewport().setPointing(false);
  for (auto* overlay : mOverlays) overlay->setPointer(std::nullopt);
  updateOverlays();
  emit ended();
}

void SketchTool::select(int stroke) {
  if (stroke == mSelected) return;
  mDocument.endMerge();
  mSelected = stroke;
  listen();
  if (const Strokes* all = strokes(); all && stroke >= 0 && stroke < int(all->size())) {
    mRadiusMm = (*all)[std::size_t(stroke)].radiusMm;
    emit radiusChanged(mRadiusMm);
  }
  emit selectedChanged(stroke);
  updateOverlays();
}

void SketchTool::setRadius(double mm) {
  if (!(mm > 0) || mm == mRadiusMm) return;
  mRadiusMm = mm;
  emit radiusChanged(mm);
  if (mSelected >= 0)
    edit(
        "Change stroke's radius",
        [this](Strokes& all) {
          if (mSelected < int(all.size())) all[std::size_t(mSelected)].radiusMm = mRadiusMm;
        },
        true);
  updateOverlays();
}

void SketchTool::remove(int stroke) {
  const Strokes* all = strokes();
  if (!all || stroke < 0 || stroke >= int(all->size())) return;
  select(-1);
  edit("Remove stroke", [stroke](Strokes& list) { list.erase(list.begin() + stroke); });
}

/// Counted once for each volume, so that fitting costs what is under the strokes.
const Histogram& SketchTool::whole() {
  const auto& layer = mDocument.scene().volume;
  std::tuple now{layer.data.id(), layer.channel, layer.frame};
  if (now != mCounted) mWhole = session::wholeHistogram(layer);
  mCounted = now;
  return mWhole;
}

void SketchTool::edit(const std::string& label, const std::function<void(Strokes&)>& change, bool merge) {
  const Strokes* all = strokes();
  if (!all || !mDocument.scene().volume.data) return;
  Strokes next = *all;
  change(next);
  mDocument.edit(
      label,
      [&](scene::Scene& scene) {
        session::setStrokes(scene::findCut(scene, mSelection.cut())->membrane->field, next, scene.volume, whole());
      },
      merge);
}

bool SketchTool::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride) {
    if (handleKey(static_cast<QKeyEvent*>(event))) return true;
  } else if (auto* view = mActive ? qobject_cast<QWidget*>(watched) : nullptr) {
    if (view == &mViews.viewport() || qobject_cast<SliceView*>(view))
      if (view->window() == mViews.window() && handleView(view, event)) return true;
  }
  return QObject::eventFilter(watched, event);
}

/// Before commands that have the same keys.
bool SketchTool::handleKey(QKeyEvent* event) {
  if (QApplication::activeModalWidget() || QApplication::activePopupWidget()) return false;
  auto* focus = QApplication::focusWidget();
  bool isTyping = qobject_cast<QLineEdit*>(focus) || qobject_cast<QAbstractSpinBox*>(focus);
  bool isInView = focus == &mViews.viewport() || qobject_cast<SliceView*>(focus);
  int key = event->key();
  bool isRadius = !isTyping && (key == Qt::Key_BracketLeft || key == Qt::Key_BracketRight);
  bool isRemove = isInView && mSelected >= 0 && key == Qt::Key_Delete;
  if (!isRadius && !isRemove && key != Qt::Key_Escape) return false;
  event->accept();
  if (event->type() != QEvent::KeyPress) return true;
  if (isRadius)
    setRadius(rounded(mRadiusMm * (key == Qt::Key_BracketRight ? kRadiusStep : 1.0 / kRadiusStep)));
  else if (isRemove)
    remove(mSelected);
  else
    mActive ? stop() : select(-1);
  return true;
}

bool SketchTool::handleView(QWidget* view, QEvent* event) {
  for (auto* overlay : mOverlays) {
    if (overlay->parentWidget() != view) continue;
    if (event->type() == QEvent::Leave) overlay->setPointer(std::nullopt);
    if (event->type() == QEvent::MouseMove) overlay->setPointer(static_cast<QMouseEvent*>(event)->position());
  }
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
      return begin(view, static_cast<QMouseEvent*>(event));
    case QEvent::MouseMove:
      if (mDrawsIn != view) return false;
      goOn(view, static_cast<QMouseEvent*>(event)->position(), false);
      return true;
    case QEvent::MouseButtonRelease:
      if (mDrawsIn != view || static_cast<QMouseEvent*>(event)->button() != Qt::LeftButton) return mDrawsIn == view;
      goOn(view, static_cast<QMouseEvent*>(event)->position(), true);
      finish();
      return true;
    case QEvent::Wheel: {
      auto* wheel = static_cast<QWheelEvent*>(event);
      if (!(wheel->modifiers() & Qt::AltModifier)) return false;
      QPoint turn = wheel->angleDelta();  // with Alt, Qt takes it for a sideways one
      double notches = (turn.y() != 0 ? turn.y() : turn.x()) / 120.0;
      if (notches != 0) setRadius(rounded(mRadiusMm * std::pow(kRadiusStep, notches)));
      return true;
    }
    default:
      return false;
  }
}

bool SketchTool::isOnHandle(QPointF place) const {
  const scene::Scene& scene = mDocument.scene();
  glm::dvec2 size(mViews.viewport().width(), mViews.viewport().height());
  const scene::Cut& cut = *scene::findCut(scene, mSelection.cut());
  return session::handleAt(session::makeCutGizmo(scene, cut, size), scene.camera, size, toVec(place), kHandlePixels) !=
         session::CutHandle::None;
}

/// In the 3D view what is meant lies behind the surface that is seen.
std::optional<glm::dvec3> SketchTool::worldAt(QWidget* view, QPointF place) {
  if (auto* slice = qobject_cast<SliceView*>(view)) return scene::worldFromSlicePixel(slice->frame(), toVec(place));
  auto pick = mViews.viewport().pickAt(place);
  if (!pick || !pick->hit) return std::nullopt;
  glm::dvec3 spacing = spacingMm(*mDocument.scene().volume.data);
  double deep = std::min(0.5 * mRadiusMm, 2.5 * std::max(spacing.x, std::max(spacing.y, spacing.z)));
  return pick->worldMm - glm::dvec3(pick->normal) * deep;
}

/// With other buttons and keys the view does what it always does; beside the data, and on handles, too.
bool SketchTool::begin(QWidget* view, QMouseEvent* event) {
  if (mDrawsIn) return mDrawsIn == view;
  if (event->button() != Qt::LeftButton || event->modifiers() != Qt::NoModifier) return false;
  if (view == &mViews.viewport() && isOnHandle(event->position())) return false;
  auto place = worldAt(view, event->position());
  if (!place) return false;
  select(-1);
  mDrawsIn = view;
  mDraft = scene::Stroke{{*place}, mRadiusMm, mAvoid};
  updateOverlays();
  return true;
}

void SketchTool::goOn(QWidget* view, QPointF place, bool isLast) {
  auto world = worldAt(view, place);
  if (!world) return;
  double step = glm::distance(*world, mDraft->pathMm.back());
  if (step > (isLast ? 0.01 : kPathStep) * mDraft->radiusMm) mDraft->pathMm.push_back(*world);
  updateOverlays();
}

void SketchTool::finish() {
  scene::Stroke stroke = std::move(*mDraft);
  mDraft.reset();
  mDrawsIn = nullptr;
  stroke.pathMm = session::simplifiedPath(stroke.pathMm, kPathTolerance * stroke.radiusMm);
  edit(stroke.avoid ? "Sketch what to let through" : "Sketch what to keep whole",
       [&](Strokes& all) { all.push_back(stroke); });
  const scene::Cut& cut = *scene::findCut(mDocument.scene(), mSelection.cut());
  if (!stroke.avoid && cut.membrane->field.byValue.empty())
    mMessages.showNote(
        tr("What is under the strokes is like all the rest: nothing in it tells it apart by its values."));
  updateOverlays();
}

}  // namespace velum::gui
