#include "gui/kit/CutTitle.h"

#include <QCoreApplication>

#include "scene/Scene.h"

namespace velum::gui {

QString cutTitle(const scene::Cut& cut, int index) {
  if (!cut.name.empty()) return QString::fromStdString(cut.name);
  return QCoreApplication::translate("velum::gui::CutTitle", "Cut %1").arg(index + 1);
}

QString cutTitle(const scene::Scene& scene, int id) {
  const scene::Cut* cut = scene::findCut(scene, id);
  return cut ? cutTitle(*cut, scene::cutPlace(scene, id)) : QString();
}

}  // namespace velum::gui
