#include "gui/extrusion/PullTool.h"

#include <algorithm>
#include <utility>

#include "gui/extrusion/PullPaint.h"
#include "gui/kit/Length.h"
#include "gui/kit/Theme.h"
#include "gui/service/SelectedCut.h"
#include "gui/tool/HandlePaint.h"
#include "scene/SectionPlane.h"
#include "session/command/Command.h"
#include "session/command/CutCommands.h"
#include "session/cut/CutEdit.h"
#include "session/extrusion/PulledEnd.h"
#include "session/growth/Growths.h"
#include "session/structure/StructureEdit.h"

namespace velum::gui {

namespace {

/// A sample lies so many voxels off a face at most.
constexpr double kSlackVoxels = 1.5;

/// A press so many pixels beside what can be pulled was meant for it.
constexpr double kBesidePixels = 40.0;

double slackOf(const scene::Scene& scene) { return kSlackVoxels * scene::sectionStep(scene); }

QString wayText(glm::dvec2 way) {
  if (way.x != 0.0) return way.x > 0.0 ? PullTool::tr("right") : PullTool::tr("left");
  return way.y > 0.0 ? PullTool::tr("down") : PullTool::tr("up");
}

}  // namespace

PullTool::PullTool(const WindowParts& parts)
    : mParts(parts), mDocument(parts.document()), mSelection(parts.selection), mToolbox(parts.toolbox) {
  connect(&mPreview, &PullPreview::drawn, this, [this] {
    if (mView) mToolbox.repaint(*mView);
  });
  connect(&parts.views.viewport(), &Viewport::refined, this, [this] {
    if (mPreview.isOn() || mPreview.image().isNull() || mParts.views.viewport().shownCount() == mShownCount) return;
    mPreview.clear();
    if (mView) mToolbox.repaint(*mView);
  });
}

bool PullTool::start() {
  const scene::Scene& scene = mDocument.shown();
  if (!scene::hasData(scene)) return false;
  mChosen.clear();
  if (hasCutToPullFrom()) return true;
  if (scene.cuts.size() >= scene::kMostCuts) return false;
  session::edit(mDocument, session::AddCut{scene::CutShape::Plane, {}}, false, "Cut to pull out of");
  mSelection.setCut(mDocument.shown().cuts.back().id);
  return true;
}

void PullTool::stop() {
  if (!mDragged.empty()) mDocument.endMerge();
  letGo();
  giveUpReading();
  mPreview.clear();
  mStroke.reset();
  mIsAsking = false;
  mChosen.clear();
  mTarget.reset();
  mMeant = {};
  mView = nullptr;
  mTag.clear();
}

void PullTool::refresh() {
  if (!scene::hasData(mDocument.shown())) return mToolbox.stop(*this);
  showPreview();
}

/// Shows what has been found of the dragged structures, as far as they are pulled.
void PullTool::showPreview() {
  if (mDragged.empty() || !mPreview.isOn()) return;
  const scene::Scene& scene = mDocument.shown();
  std::vector<session::Pulled> pulled;
  for (const auto& [pull, drag, end, before] : mDragged)
    if (const scene::Cut* cut = scene::findCut(scene, pull.cut))
      pulled.push_back({pull.cut, pull.structure, session::extrusionOf(*cut, pull.structure), before});
  mPreview.show(scene, pulled, {mView->widget().width(), mView->widget().height()});
}

/// Lets the view draw again; the preview stays over the view's picture until the next one is there.
void PullTool::letGo() {
  mDragged.clear();
  mPreview.end();
  mShownCount = mParts.views.viewport().shownCount();
  mParts.views.viewport().pause(0);
}

std::optional<PullTool::Target> PullTool::targetAt(const ViewPoint& at) const {
  const auto& pick = at.pick();
  if (!pick || !pick->hit || pick->instance != 0) return std::nullopt;
  const scene::Scene& scene = mDocument.shown();
  Target target{pick->world, scene.labels.visible ? pick->structure : 0, {}};
  target.cuts = session::cutsUnder(scene, target.world, target.structure, slackOf(scene));
  if (target.cuts.empty()) return std::nullopt;
  auto meant = std::find(target.cuts.begin(), target.cuts.end(), mMeant.cut);
  if (meant != target.cuts.end() && mMeant.structure == target.structure)
    std::rotate(target.cuts.begin(), meant, meant + 1);
  return target;
}

/// The choice holds while the pointer is where several cuts hold the structure, or on nothing.
void PullTool::mean(const Target& target) {
  mMeant = target.cuts.size() > 1 ? Meant{target.structure, target.cuts.front()} : Meant{};
}

/// The cut out of which the next drag pulls, or this one does.
int PullTool::supporting() const { return mDragged.empty() && mTarget ? mTarget->cuts.front() : mSelection.cut(); }

/// Something is seen there, or a structure that can be pulled is near: not a place from which to turn the camera.
bool PullTool::isBeside(const ViewPoint& at) const {
  if (at.isOnSection()) return false;
  if (at.pick() && at.pick()->hit) return true;
  for (double away : {0.5 * kBesidePixels, kBesidePixels})
    for (QPointF way : {QPointF(1, 0), QPointF(0, 1), QPointF(-1, 0), QPointF(0, -1)})
      if (targetAt(ViewPoint(at.view(), mDocument.shown(), at.place() + away * way))) return true;
  return false;
}

/// For other buttons and keys, and on the empty ground, the view does what it always does.
bool PullTool::press(const PointerEvent& event) {
  bool isPlain = event.keys == Qt::NoModifier || event.keys == Qt::ShiftModifier;
  bool isStroke = event.keys == Qt::ControlModifier;
  if (event.button == Qt::LeftButton && saysNotThis(event)) {
    beginStroke(event.at, Stroke::NotThis);
    return true;
  }
  bool isPart = event.keys == (Qt::ControlModifier | Qt::ShiftModifier);
  if (event.button != Qt::LeftButton || (!isPlain && !isStroke && !isPart)) return false;
  auto target = targetAt(event.at);
  if (!target && (isStroke || !isBeside(event.at))) return false;
  if (!target) {
    mParts.messages.showNote(
        tr("Nothing here to pull: press on the cut's face. A drag on the empty ground turns the view."));
    return true;
  }
  if (!isStroke) return beginWhenRead(*target, event.at, isPlain && event.keys & Qt::ShiftModifier, isPart);
  beginStroke(event.at, Stroke::Add);
  return true;
}

/// @param isPart  of a label only what is joined to the place is taken
bool PullTool::begin(const Target& target, const ViewPoint& at, bool goesOn, bool isPart) {
  const scene::Scene& scene = mDocument.shown();
  auto pull = isPart ? session::beginPartPull(scene, target.cuts.front(), target.world, target.structure)
                     : session::beginPull(scene, target.cuts.front(), target.world, target.structure,
                                          mParts.session.histograms());
  if (!pull) {
    mParts.messages.showNote(tr("Nothing stands out here; click well inside of what you mean"));
    return true;
  }
  if (!goesOn) mChosen.clear();
  std::erase_if(mChosen, [&](const auto& other) {
    return (other.structure == pull->structure && other.cut == pull->cut) || !scene::findCut(scene, other.cut);
  });
  mChosen.push_back(*pull);
  mTarget = target;
  mean(target);
  mDragged.clear();
  for (const auto& one : mChosen) {
    const scene::Cut& cut = *scene::findCut(scene, one.cut);
    double distance = session::extrusionOf(cut, one.structure);
    if (!std::isfinite(distance)) {
      mParts.messages.showNote(
          tr("%1 is spared whole by this cut already: take that off in the list of cuts to pull it").arg(nameOf(one)));
      continue;
    }
    // Where a structure that is still to be found ends is not known yet.
    double end = session::pulledEnd(scene, cut, one.added ? 0 : one.structure);
    mDragged.push_back(
        {one, session::ExtrusionDrag(at.space(), at.pixel(), cut, target.world, distance), end, distance});
  }
  mSelection.setCut(pull->cut);
  mSelection.setStructure(pull->structure);
  mView = &at.view();
  if (!at.isOnSection() && !mDragged.empty()) mPreview.begin();
  return true;
}

void PullTool::pullTo(const ViewPoint& at) {
  if (mDragged.empty()) return;
  std::vector<double> distances;
  for (const auto& one : mDragged) distances.push_back(std::min(one.drag.distanceAt(at.pixel()), one.end));
  setDistances(distances);
  const Dragged& last = mDragged.back();
  mTag = tr("%1: %2").arg(nameOf(last.pull), Length(mDocument.shown()).text(distances.back()));
  if (distances.back() == 0.0)
    mTag = tr("%1, drag %2 to pull it out").arg(mTag, wayText(last.drag.wayOut()));
  else if (distances.back() == last.end)
    mTag = tr("%1, its end").arg(mTag);
}

/// One step of undo with all of the drag.
void PullTool::setDistances(const std::vector<double>& distances) {
  QString label = mDragged.size() == 1 ? tr("Pull out %1").arg(nameOf(mDragged.front().pull))
                                       : tr("Pull out %n structures", nullptr, int(mDragged.size()));
  session::editByHand(
      mDocument, label.toStdString(),
      [&](scene::Scene& scene) {
        for (std::size_t i = 0; i < mDragged.size(); ++i) session::pullTo(scene, mDragged[i].pull, distances[i]);
      },
      true);
}

/// A structure that has grown during the drag may end before the pointer's place.
void PullTool::endAtTheirEnds() {
  const scene::Scene& scene = mDocument.shown();
  std::vector<double> distances;
  bool isFurther = false;
  for (const auto& one : mDragged) {
    const scene::Cut* cut = scene::findCut(scene, one.pull.cut);
    double distance = cut ? session::extrusionOf(*cut, one.pull.structure) : 0.0;
    double end = cut && distance > 0.0 ? session::pulledEnd(scene, *cut, one.pull.structure) : distance;
    isFurther |= distance > end && end > 0.0;
    distances.push_back(end > 0.0 ? std::min(distance, end) : distance);
  }
  if (isFurther) setDistances(distances);
}

void PullTool::drag(const PointerEvent& event) {
  mPointer = event.at.place();
  if (mStroke)
    strokeTo(event.at);
  else
    pullTo(event.at);
  mToolbox.repaint(event.at.view());
}

void PullTool::release(const PointerEvent& event) {
  if (mStroke) endStroke();
  mIsReleased = true;
  endDrag();
  mToolbox.repaint(event.at.view());
}

void PullTool::endDrag() {
  endAtTheirEnds();
  mDocument.endMerge();
  letGo();
  mTag.clear();
}

std::optional<Qt::CursorShape> PullTool::hover(const ViewPoint& at) {
  mTarget = targetAt(at);
  if (mTarget) mean(*mTarget);
  mView = &at.view();
  mPointer = at.place();
  mTag = mTarget ? tagOf(*mTarget) : QString();
  mToolbox.repaint();
  return mTarget ? Qt::OpenHandCursor : at.view().restCursor();
}

void PullTool::leave() {
  mTarget.reset();
  mTag.clear();
  mToolbox.repaint();
}

/// Means the other of two planes to pull out of.
void PullTool::toggle() {
  if (!mTarget || mTarget->cuts.size() < 2) return;
  std::rotate(mTarget->cuts.begin(), mTarget->cuts.begin() + 1, mTarget->cuts.end());
  mean(*mTarget);
  mSelection.setCut(mTarget->cuts.front());
  mTag = tagOf(*mTarget);
  mToolbox.repaint();
}

KeyAnswer PullTool::key(const KeyStroke& stroke) {
  if (stroke.isTyping) return {};
  bool isTwo = mTarget && mTarget->cuts.size() > 1;
  if (stroke.key == Qt::Key_Space && stroke.keys == Qt::NoModifier && isTwo && mDragged.empty())
    return [this] { toggle(); };
  if (stroke.key == Qt::Key_BracketRight) return [this] { movePlane(1.0); };
  if (stroke.key == Qt::Key_BracketLeft) return [this] { movePlane(-1.0); };
  if (stroke.key == Qt::Key_Escape && mIsAsking) return [this] { mIsAsking = false; };
  if (stroke.key == Qt::Key_Escape && mParts.session.growth().isGrowing()) return [this] { emit stopGrowingAsked(); };
  return {};
}

/// Moves the supporting plane along its normal, by the step of sections.
bool PullTool::movePlane(double steps) {
  const scene::Cut* cut = scene::findCut(mDocument.shown(), mSelection.cut());
  if (!cut || !session::canPullFrom(*cut)) return false;
  glm::dvec3 step = session::pullDirection(*cut, cut->centre) * (steps * scene::sectionStep(mDocument.shown()));
  editSelectedCut(
      mDocument, mSelection, "Move cut", [&](scene::Cut& one) { one.centre += step; }, true);
  return true;
}

/// Window managers keep Alt and the wheel for themselves; on sections Ctrl and the wheel zoom.
bool PullTool::wheel(const PointerEvent& event, double notches) {
  bool isMeant = event.keys & Qt::AltModifier || (event.keys & Qt::ControlModifier && !event.at.isOnSection());
  return isMeant && movePlane(notches);
}

void PullTool::paint(ViewPainter& over) const {
  if (!over.space.section() && !mPreview.image().isNull())
    over.painter.drawImage(QRectF(QPointF(), over.size), mPreview.image());
  if (!over.space.section()) paintPlanes(over, mDocument.shown(), supporting());
  if (mStroke) {
    bool isAdd = mStrokeKind == Stroke::Add;
    mStroke->paint(over, 0.5 * scene::sectionStep(mDocument.shown()), isAdd ? kAccent : kAlarm);
  }
  if (&over.view == mView && !mTag.isEmpty()) drawTag(over.painter, mPointer, over.size, mTag);
}

}  // namespace velum::gui
