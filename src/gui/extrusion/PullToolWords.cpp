// What the tool says: its hint, and the label beside the pointer.
#include <algorithm>
#include <cmath>

#include "gui/extrusion/PullTool.h"
#include "gui/kit/Length.h"
#include "session/growth/Growths.h"
#include "session/structure/StructureEdit.h"

namespace velum::gui {

bool PullTool::hasCutToPullFrom() const {
  const auto& cuts = mDocument.shown().cuts;
  return std::any_of(cuts.begin(), cuts.end(), session::canPullFrom);
}

QString PullTool::hint() const {
  if (!hasCutToPullFrom()) return tr("Add a cut first: there is none to pull out of. Esc ends.");
  if (mIsAsking)
    return tr("Click on what is not of it, or draw over it: it gives up what is nearer to that. Esc takes this back.");
  if (mTarget && mTarget->cuts.size() > 1)
    return tr("Two planes hold this: Space changes the one that it is pulled out of. Esc ends.");
  if (session::lastGrowth(mDocument.shown(), mSelection.structure()))
    return tr(
        "Drag a structure out of the cut. Shift takes several. A stroke with Ctrl adds to the selected one, a click or "
        "a "
        "stroke with Ctrl and Shift says what is not of it. Esc ends.");
  if (mTarget && mTarget->structure != 0)
    return tr(
        "Drag the structure out of the cut. Shift takes several, Ctrl and Shift only the part that is joined to the "
        "place. "
        "Esc ends.");
  return tr(
      "Drag a structure out of the cut. Shift takes several, Ctrl and the wheel, or [ and ], move the plane. Esc "
      "ends.");
}

QString PullTool::nameOf(const session::Pull& pull) const {
  if (pull.added) return QString::fromStdString(pull.added->name);
  if (pull.structure == 0) return tr("What has no label");
  return QString::fromStdString(session::structureName(mDocument.shown(), pull.structure));
}

/// The label: the structure under the pointer, and how far it stands out.
QString PullTool::tagOf(const Target& target) const {
  const scene::Scene& scene = mDocument.shown();
  const scene::Cut* cut = scene::findCut(scene, target.cuts.front());
  if (!cut || target.structure == 0) return {};
  QString name = QString::fromStdString(session::structureName(scene, target.structure));
  double distance = session::extrusionOf(*cut, target.structure);
  if (distance == 0.0) return name;
  return tr("%1: %2").arg(name, std::isfinite(distance) ? Length(scene).text(distance) : tr("whole"));
}

}  // namespace velum::gui
