// With Ctrl a stroke gives a structure that was pulled out more places to grow from; with Ctrl and Shift it shows which
// parts do not belong to the structure.
#include <QLocale>
#include <algorithm>
#include <utility>

#include "gui/extrusion/PullTool.h"
#include "scene/SectionPlane.h"
#include "session/command/Command.h"
#include "session/growth/Growths.h"
#include "session/structure/StructureEdit.h"

namespace velum::gui {

namespace {

/// The place that a stroke means lies at most so many voxels behind the surface.
constexpr double kBehindVoxels = 1.0;

}  // namespace

void PullTool::askWhatIsNotOfIt() { mIsAsking = true; }

/// True on the selected structure, or on parts that it could have leaked into. On another labelled structure the keys
/// mean that only a part of this structure is pulled.
bool PullTool::saysNotThis(const PointerEvent& event) const {
  const scene::Growth* last = session::lastGrowth(mDocument.shown(), mSelection.structure());
  if (!last) return false;
  if (mIsAsking && event.keys == Qt::NoModifier) return bool(event.at.world());
  if (event.keys != (Qt::ControlModifier | Qt::ShiftModifier) || !event.at.world()) return false;
  int structure = event.at.structure();
  return structure == 0 || structure == mSelection.structure();
}

/// Only a structure that was grown can grow from more places, or from fewer.
void PullTool::beginStroke(const ViewPoint& at, Stroke stroke) {
  int structure = mSelection.structure();
  mTag.clear();
  if (session::lastGrowth(mDocument.shown(), structure)) {
    mStroke.emplace();
    mStrokeKind = stroke;
    mView = &at.view();
    return strokeTo(at);
  }
  const scene::Structure* row = session::findStructure(mDocument.shown(), structure);
  mParts.messages.showNote(
      row ? tr("%1 has labels of its own: a stroke with Ctrl adds to what was found from its values")
                .arg(QString::fromStdString(row->name))
          : tr("Pull a structure out, or select one that was: a stroke with Ctrl adds to it"));
}

void PullTool::strokeTo(const ViewPoint& at) {
  if (mStrokeKind == Stroke::NotThis) {
    auto place = at.material(kBehindVoxels * scene::sectionStep(mDocument.shown()));
    if (place)
      mStroke->goOn(*place, {at.structure(), 0});
    else
      mStroke->lift();
    return;
  }
  auto target = targetAt(at);
  if (target)
    mStroke->goOn(target->world, {target->structure, target->cuts.front()});
  else
    mStroke->lift();
}

void PullTool::endStroke() {
  SeedStroke stroke = *std::exchange(mStroke, std::nullopt);
  int structure = mSelection.structure();
  if (!session::lastGrowth(mDocument.shown(), structure)) return;
  auto places = stroke.places(*mDocument.shown().volume.data);
  if (mStrokeKind == Stroke::Add) return addPlaces(structure, places);
  mIsAsking = false;
  takeAway(structure, places);
}

/// Tissue that is joined to the places under the stroke becomes part of the structure, as far as the structure is
/// pulled.
void PullTool::addPlaces(int structure, const std::vector<glm::dvec3>& places) {
  const scene::Growth* last = session::lastGrowth(mDocument.shown(), structure);
  QString name = QString::fromStdString(session::structureName(mDocument.shown(), structure));
  glm::dvec2 range = mDocument.shown().volume.data->range;
  double low = std::max(last->low, range.x), high = std::min(last->high, range.y);
  std::size_t count = 0;
  session::editByHand(mDocument, tr("Add to %1").arg(name).toStdString(),
                      [&](scene::Scene& scene) { count = session::addSeeds(scene, structure, places); });
  if (count == 0)
    mParts.messages.showNote(tr("Nothing was added to %1: nothing under the stroke has its values, %2 to %3")
                                 .arg(name, QLocale().toString(low), QLocale().toString(high)));
}

/// The structure gives up tissue that is nearer to these places than to its own.
void PullTool::takeAway(int structure, const std::vector<glm::dvec3>& places) {
  QString name = QString::fromStdString(session::structureName(mDocument.shown(), structure));
  std::size_t count = 0;
  session::editByHand(mDocument, tr("Not this: %1").arg(name).toStdString(),
                      [&](scene::Scene& scene) { count = session::addOthers(scene, structure, places); });
  if (count == 0)
    mParts.messages.showNote(
        tr("%1 gives up nothing: it could not grow there. Click on what it has leaked into, away from where it was "
           "pressed on")
            .arg(name));
}

}  // namespace velum::gui
