#include "gui/membrane/BrushTool.h"

#include <algorithm>
#include <utility>

#include "gui/membrane/StrengthCanvas.h"
#include "gui/service/SelectedCut.h"
#include "gui/tool/StrokePaint.h"
#include "session/membrane/Sketch.h"

namespace velum::gui {

namespace {

constexpr double kPathStep = 0.2;       // between points of a path that is being drawn, in radii
constexpr double kLastStep = 0.01;      // to its last one
constexpr double kPathTolerance = 0.1;  // of the path that is kept, in radii

}  // namespace

BrushTool::BrushTool(bool avoid, const WindowParts& parts, Sketch& sketch)
    : mAvoid(avoid),
      mDocument(parts.document()),
      mSelection(parts.selection),
      mSketch(sketch),
      mToolbox(parts.toolbox),
      mMessages(parts.messages) {
  connect(&mSelection, &Selection::cutChanged, this, [this] { mToolbox.stop(*this); });
}

bool BrushTool::start() {
  if (!mSketch.isReady()) return false;
  mSketch.select(-1);
  return true;
}

void BrushTool::stop() {
  mDraft.reset();
  mView = nullptr;
}

void BrushTool::refresh() {
  if (!mSketch.isReady()) mToolbox.stop(*this);
}

/// In the 3D view the place that is meant lies behind the visible surface, but no deeper than the brush reaches.
std::optional<glm::dvec3> BrushTool::placeUnder(const ViewPoint& at) const {
  return at.material(0.5 * mSketch.radius());
}

/// For other buttons and keys, beside the data, and on handles the view does what it always does.
bool BrushTool::press(const PointerEvent& event) {
  if (event.button != Qt::LeftButton || event.keys != Qt::NoModifier || mToolbox.isInTheWay(event.at)) return false;
  auto place = placeUnder(event.at);
  if (!place) return false;
  mSketch.select(-1);
  mDraft = scene::Stroke{{*place}, mSketch.radius(), mAvoid};
  showBrush(event.at);
  return true;
}

void BrushTool::goOn(const ViewPoint& at, double leastRadii) {
  auto world = placeUnder(at);
  if (world && glm::distance(*world, mDraft->path.back()) > leastRadii * mDraft->radius) mDraft->path.push_back(*world);
}

void BrushTool::drag(const PointerEvent& event) {
  goOn(event.at, kPathStep);
  showBrush(event.at);
}

void BrushTool::release(const PointerEvent& event) {
  goOn(event.at, kLastStep);
  scene::Stroke stroke = *std::exchange(mDraft, std::nullopt);
  stroke.path = session::simplifiedPath(stroke.path, kPathTolerance * stroke.radius);
  mSketch.addStroke(stroke, mAvoid ? "Sketch what to let through" : "Sketch what to protect");
  const scene::Cut* cut = selectedMembrane(mDocument, mSelection);
  if (!mAvoid && cut && cut->membrane->field.byValue.empty())
    mMessages.showNote(
        tr("What is under the strokes is like all the rest: nothing in it tells it apart by its values."));
  mToolbox.repaint();
}

void BrushTool::showBrush(const ViewPoint& at) {
  mView = &at.view();
  mPointer = at.place();
  mToolbox.repaint();
}

std::optional<Qt::CursorShape> BrushTool::hover(const ViewPoint& at) {
  showBrush(at);
  return mToolbox.isInTheWay(at) ? std::nullopt : std::optional(Qt::CrossCursor);
}

void BrushTool::leave() {
  mView = nullptr;
  mToolbox.repaint();
}

bool BrushTool::wheel(const PointerEvent& event, double notches) {
  if (!(event.keys & Qt::AltModifier)) return false;
  mSketch.turnRadius(notches);
  return true;
}

void BrushTool::paint(ViewPainter& over) const {
  if (!over.view.showsHandles()) mSketch.paint(over);  // while one draws they are seen in any case
  QColor color = mAvoid ? kAvoidColor : kKeepColor;
  if (mDraft) paintStroke(over, mDraft->path, mDraft->radius, color, false);
  if (&over.view == mView) paintBrush(over, mPointer, mSketch.radius(), color);
}

}  // namespace velum::gui
