#include "PullTool.h"

#include <QLocale>
#include <algorithm>
#include <utility>

#include "PullPaint.h"
#include "kit/Length.h"
#include "tool/HandlePaint.h"
#include "velum/scene/SectionPlane.h"
#include "velum/session/cut/CutEdit.h"
#include "velum/session/growth/Growths.h"
#include "velum/session/structure/StructureEdit.h"

namespace velum::gui {

namespace {

/// A sample lies so many voxels off a face at most.
constexpr double kSlackVoxels = 1.5;

double slackOf(const scene::Scene& scene) { return kSlackVoxels * scene::sectionStep(scene); }

bool hasCutToPullFrom(const scene::Scene& scene) {
  return std::any_of(scene.cuts.begin(), scene.cuts.end(), session::canPullFrom);
}

}  // namespace

PullTool::PullTool(const WindowParts& parts)
    : mParts(parts), mDocument(parts.document()), mSelection(parts.selection), mToolbox(parts.toolbox) {}

bool PullTool::start() {
  const scene::Scene& scene = mDocument.scene();
  if (!scene::hasData(scene)) return false;
  mChosen.clear();
  if (hasCutToPullFrom(scene)) return true;
  int id = 0;
  mDocument.edit("Cut to pull out of", [&](scene::Scene& s) {
    scene::Cut plane = session::makeCut(s, scene::CutShape::Plane);
    plane.name = session::newCutName(s, plane.shape);
    id = scene::addCut(s, plane);
  });
  mSelection.setCut(id);
  return true;
}

void PullTool::stop() {
  if (!mDragged.empty()) mDocument.endMerge();
  mDragged.clear();
  mStroke.reset();
  mChosen.clear();
  mTarget.reset();
  mMeant = {};
  mView = nullptr;
  mTag.clear();
}

void PullTool::refresh() {
  if (!scene::hasData(mDocument.scene())) mToolbox.stop(*this);
}

QString PullTool::hint() const {
  if (!hasCutToPullFrom(mDocument.scene())) return tr("Add a cut first: there is none to pull out of. Esc ends.");
  if (mTarget && mTarget->cuts.size() > 1)
    return tr("Two planes hold this: Space changes the one that it is pulled out of. Esc ends.");
  if (session::lastGrowth(mDocument.scene(), mSelection.structure()))
    return tr(
        "Drag a structure out of the cut. Shift takes several, a stroke with Ctrl adds to the selected one. Esc ends.");
  return tr("Drag a structure out of the cut. Shift takes several, Alt and the wheel move the plane. Esc ends.");
}

std::optional<PullTool::Target> PullTool::targetAt(const ViewPoint& at) const {
  const auto& pick = at.pick();
  if (!pick || !pick->hit || pick->instance != 0) return std::nullopt;
  const scene::Scene& scene = mDocument.scene();
  Target target{pick->world, scene.labels.visible ? pick->structure : 0, {}};
  target.cuts = session::cutsUnder(scene, target.world, target.structure, slackOf(scene));
  if (target.cuts.empty()) return std::nullopt;
  auto meant = std::find(target.cuts.begin(), target.cuts.end(), mMeant.cut);
  if (meant != target.cuts.end() && mMeant.structure == target.structure)
    std::rotate(target.cuts.begin(), meant, meant + 1);
  return target;
}

/// It stays so while the pointer is where several cuts hold the structure, or on nothing.
void PullTool::mean(const Target& target) {
  mMeant = target.cuts.size() > 1 ? Meant{target.structure, target.cuts.front()} : Meant{};
}

/// The cut out of which the next drag pulls, or this one does.
int PullTool::supporting() const { return mDragged.empty() && mTarget ? mTarget->cuts.front() : mSelection.cut(); }

/// With other buttons and keys the view does what it always does; beside what can be pulled, too.
bool PullTool::press(const PointerEvent& event) {
  bool isPlain = event.keys == Qt::NoModifier || event.keys == Qt::ShiftModifier;
  bool isStroke = event.keys == Qt::ControlModifier;
  if (event.button != Qt::LeftButton || (!isPlain && !isStroke)) return false;
  auto target = targetAt(event.at);
  if (!target) return false;
  if (!isStroke) return begin(*target, event.at, event.keys & Qt::ShiftModifier);
  beginStroke(event.at);
  return true;
}

bool PullTool::begin(const Target& target, const ViewPoint& at, bool goesOn) {
  const scene::Scene& scene = mDocument.scene();
  auto pull =
      session::beginPull(scene, target.cuts.front(), target.world, target.structure, mParts.session.histograms());
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
    mDragged.push_back({one, session::ExtrusionDrag(at.space(), at.pixel(), cut, target.world, distance)});
  }
  mSelection.setCut(pull->cut);
  mSelection.setStructure(pull->structure);
  mView = &at.view();
  return true;
}

void PullTool::pullTo(const ViewPoint& at) {
  if (mDragged.empty()) return;
  QString label = mDragged.size() == 1 ? tr("Pull out %1").arg(nameOf(mDragged.front().pull))
                                       : tr("Pull out %n structures", nullptr, int(mDragged.size()));
  double distance = 0.0;
  mDocument.edit(
      label.toStdString(),
      [&](scene::Scene& scene) {
        for (const auto& one : mDragged) {
          distance = one.drag.distanceAt(at.pixel());
          session::pullTo(scene, one.pull, distance);
        }
      },
      true);
  mTag = tr("%1: %2").arg(nameOf(mDragged.back().pull), Length(mDocument.scene()).text(distance));
}

/// Only what was grown can grow from more places.
void PullTool::beginStroke(const ViewPoint& at) {
  int structure = mSelection.structure();
  mTag.clear();
  if (session::lastGrowth(mDocument.scene(), structure)) {
    mStroke.emplace();
    mView = &at.view();
    return strokeTo(at);
  }
  const scene::Structure* row = session::findStructure(mDocument.scene(), structure);
  mParts.messages.showNote(
      row ? tr("%1 has labels of its own: a stroke with Ctrl adds to what was found from its values")
                .arg(QString::fromStdString(row->name))
          : tr("Pull a structure out, or select one that was: a stroke with Ctrl adds to it"));
}

void PullTool::strokeTo(const ViewPoint& at) {
  auto target = targetAt(at);
  if (target)
    mStroke->goOn(target->world, {target->structure, target->cuts.front()});
  else
    mStroke->lift();
}

/// What is joined to the places under the stroke becomes part of the structure, as far as that is pulled.
void PullTool::endStroke() {
  SeedStroke stroke = *std::exchange(mStroke, std::nullopt);
  int structure = mSelection.structure();
  const scene::Growth* last = session::lastGrowth(mDocument.scene(), structure);
  if (!last) return;
  QString name = QString::fromStdString(session::structureName(mDocument.scene(), structure));
  glm::dvec2 range = mDocument.scene().volume.data->range;
  double low = std::max(last->low, range.x), high = std::min(last->high, range.y);
  std::size_t count = 0;
  mDocument.edit(tr("Add to %1").arg(name).toStdString(), [&](scene::Scene& scene) {
    count = session::addSeeds(scene, structure, stroke.places(*scene.volume.data));
  });
  if (count == 0)
    mParts.messages.showNote(tr("Nothing was added to %1: nothing under the stroke has its values, %2 to %3")
                                 .arg(name, QLocale().toString(low), QLocale().toString(high)));
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
  mDocument.endMerge();
  mDragged.clear();
  mTag.clear();
  mToolbox.repaint(event.at.view());
}

QString PullTool::nameOf(const session::Pull& pull) const {
  if (pull.added) return QString::fromStdString(pull.added->name);
  if (pull.structure == 0) return tr("What has no label");
  return QString::fromStdString(session::structureName(mDocument.scene(), pull.structure));
}

/// What stands under the pointer, and how far it stands out.
QString PullTool::tagOf(const Target& target) const {
  const scene::Scene& scene = mDocument.scene();
  const scene::Cut* cut = scene::findCut(scene, target.cuts.front());
  if (!cut || target.structure == 0) return {};
  QString name = QString::fromStdString(session::structureName(scene, target.structure));
  double distance = session::extrusionOf(*cut, target.structure);
  if (distance == 0.0) return name;
  return tr("%1: %2").arg(name, std::isfinite(distance) ? Length(scene).text(distance) : tr("whole"));
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

/// Out of the other of two planes.
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
  if (stroke.key == Qt::Key_Escape && mParts.session.growth().isGrowing()) return [this] { emit stopGrowingAsked(); };
  return {};
}

bool PullTool::wheel(const PointerEvent& event, double notches) {
  const scene::Cut* cut = scene::findCut(mDocument.scene(), mSelection.cut());
  if (!(event.keys & Qt::AltModifier) || !cut || !session::canPullFrom(*cut)) return false;
  glm::dvec3 step = session::pullDirection(*cut, cut->centre) * (notches * scene::sectionStep(mDocument.scene()));
  mDocument.edit(
      "Move cut", [&](scene::Scene& scene) { scene::findCut(scene, mSelection.cut())->centre += step; }, true);
  return true;
}

void PullTool::paint(ViewPainter& over) const {
  if (!over.space.section()) paintPlanes(over, mDocument.scene(), supporting());
  if (mStroke) mStroke->paint(over, 0.5 * scene::sectionStep(mDocument.scene()));
  if (&over.view == mView && !mTag.isEmpty()) drawTag(over.painter, mPointer, over.size, mTag);
}

}  // namespace velum::gui
