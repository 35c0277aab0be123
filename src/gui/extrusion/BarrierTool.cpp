#include "gui/extrusion/BarrierTool.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gui/kit/Theme.h"
#include "gui/tool/StrokePaint.h"
#include "scene/SectionPlane.h"
#include "session/command/Command.h"
#include "session/command/GrowthCommands.h"
#include "session/command/StructureCommands.h"
#include "session/extrusion/Pull.h"
#include "session/growth/Growths.h"
#include "session/membrane/Sketch.h"
#include "session/structure/StructureEdit.h"

namespace velum::gui {

namespace {

constexpr double kFirstVoxels = 3.0;    // radius of a first stroke
constexpr double kTurn = 1.15;          // factor by which a notch of the wheel widens the stroke
constexpr double kPathStep = 0.2;       // between points of a path that is being drawn, in radii
constexpr double kPathTolerance = 0.1;  // of the path that is kept, in radii

}  // namespace

BarrierTool::BarrierTool(const WindowParts& parts)
    : mDocument(parts.document()), mSelection(parts.selection), mToolbox(parts.toolbox) {}

bool BarrierTool::isReady() const { return session::lastGrowth(mDocument.shown(), mSelection.structure()); }

bool BarrierTool::start() {
  if (mRadius <= 0.0) mRadius = kFirstVoxels * scene::sectionStep(mDocument.shown());
  return isReady();
}

void BarrierTool::stop() {
  mDraft.reset();
  mView = nullptr;
}

void BarrierTool::refresh() {
  if (!isReady()) mToolbox.stop(*this);
}

QString BarrierTool::hint() const {
  return tr("Draw across the place where the structure leaks. [ and ] change the width. Esc ends.");
}

bool BarrierTool::press(const PointerEvent& event) {
  if (event.button != Qt::LeftButton || event.keys != Qt::NoModifier || mToolbox.isInTheWay(event.at)) return false;
  auto place = event.at.material(0.5 * mRadius);
  if (!place) return false;
  mDraft = scene::Barrier{{*place}, mRadius};
  showBrush(event.at);
  return true;
}

void BarrierTool::goOn(const ViewPoint& at) {
  auto world = at.material(0.5 * mRadius);
  if (world && glm::distance(*world, mDraft->path.back()) > kPathStep * mRadius) mDraft->path.push_back(*world);
}

void BarrierTool::drag(const PointerEvent& event) {
  if (!mDraft) return;
  goOn(event.at);
  showBrush(event.at);
}

void BarrierTool::release(const PointerEvent& event) {
  if (!mDraft) return;
  goOn(event.at);
  scene::Barrier barrier = *std::exchange(mDraft, std::nullopt);
  barrier.path = session::simplifiedPath(barrier.path, kPathTolerance * barrier.radius);
  const scene::Scene& scene = mDocument.shown();
  int id = mSelection.structure();
  if (session::lastGrowth(scene, id) && session::findStructure(scene, id))
    session::edit(mDocument,
                  session::DrawBarrier{session::structureNames(scene, {id})[0], barrier.path, barrier.radius});
  mToolbox.repaint();
}

void BarrierTool::showBrush(const ViewPoint& at) {
  mView = &at.view();
  mPointer = at.place();
  mToolbox.repaint();
}

std::optional<Qt::CursorShape> BarrierTool::hover(const ViewPoint& at) {
  showBrush(at);
  return mToolbox.isInTheWay(at) ? std::nullopt : std::optional(Qt::CrossCursor);
}

void BarrierTool::leave() {
  mView = nullptr;
  mToolbox.repaint();
}

bool BarrierTool::wheel(const PointerEvent& event, double notches) {
  if (!(event.keys & Qt::AltModifier)) return false;
  widen(notches);
  return true;
}

void BarrierTool::widen(double notches) {
  double step = scene::sectionStep(mDocument.shown());
  mRadius = std::clamp(mRadius * std::pow(kTurn, notches), 0.5 * step, 200.0 * step);
  mToolbox.repaint();
}

/// Window managers keep Alt and the wheel for themselves.
KeyAnswer BarrierTool::key(const KeyStroke& stroke) {
  if (stroke.isTyping) return {};
  if (stroke.key == Qt::Key_BracketRight) return [this] { widen(1.0); };
  if (stroke.key == Qt::Key_BracketLeft) return [this] { widen(-1.0); };
  return {};
}

void BarrierTool::paint(ViewPainter& over) const {
  if (const scene::Growth* growth = session::lastGrowth(mDocument.shown(), mSelection.structure()))
    for (const auto& barrier : growth->barriers) paintStroke(over, barrier.path, barrier.radius, kAlarm, false);
  if (mDraft) paintStroke(over, mDraft->path, mDraft->radius, kAlarm, false);
  if (&over.view == mView) paintBrush(over, mPointer, mRadius, kAlarm);
}

}  // namespace velum::gui
