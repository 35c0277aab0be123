// With Ctrl a stroke gives a structure that was pulled out more places to grow from.
#include <QLocale>
#include <algorithm>
#include <utility>

#include "PullTool.h"
#include "velum/session/growth/Growths.h"
#include "velum/session/structure/StructureEdit.h"

namespace velum::gui {

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

}  // namespace velum::gui
