#include "gui/cut/CutList.h"

#include <QKeyEvent>

#include "gui/kit/CutTitle.h"
#include "session/cut/ShapeTraits.h"

namespace velum::gui {

namespace {

constexpr int kMostCutRows = 5;

}  // namespace

CutList::CutList(QWidget* parent) : EyeList("cutList", kMostCutRows, parent) {
  setAccessibleName(tr("Cuts"));
  setToolTip(tr("The eye turns a cut on and off; F2 or a double click renames it; Alt+Up and Alt+Down move it"));
}

void CutList::setCuts(const std::vector<scene::Cut>& cuts, int selected) {
  std::vector<Row> rows;
  for (const scene::Cut& cut : cuts)
    rows.push_back({.id = cut.id,
                    .icon = session::traitsOf(cut.shape).icon,
                    .name = cutTitle(cut, int(rows.size())),
                    .isOn = cut.enabled});
  setRows(rows, selected);
}

void CutList::keyPressEvent(QKeyEvent* event) {
  bool up = event->key() == Qt::Key_Up, down = event->key() == Qt::Key_Down;
  if ((event->modifiers() & Qt::AltModifier) && (up || down)) {
    emit moveAsked(up ? -1 : 1);
    return;
  }
  EyeList::keyPressEvent(event);
}

}  // namespace velum::gui
