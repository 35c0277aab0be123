#include "gui/view/SideNames.h"

#include <QObject>

#include "gui/kit/Length.h"
#include "gui/view/SectionOverlay.h"
#include "scene/Scene.h"

namespace velum::gui {

QString sideName(const scene::Scene& scene, int axis, bool isPlus) {
  const QString patient[3][2] = {{QObject::tr("right"), QObject::tr("left")},
                                 {QObject::tr("anterior"), QObject::tr("posterior")},
                                 {QObject::tr("inferior"), QObject::tr("superior")}};
  const QString thing[3][2] = {{QObject::tr("right"), QObject::tr("left")},
                               {QObject::tr("front"), QObject::tr("back")},
                               {QObject::tr("bottom"), QObject::tr("top")}};
  return (hasPatientLetters(scene) ? patient : thing)[axis][isPlus ? 1 : 0];
}

QString viewName(const scene::Scene& scene, scene::StandardView view) {
  using scene::StandardView;
  switch (view) {
    case StandardView::Anterior:
      return sideName(scene, 1, false);
    case StandardView::Posterior:
      return sideName(scene, 1, true);
    case StandardView::Left:
      return sideName(scene, 0, true);
    case StandardView::Right:
      return sideName(scene, 0, false);
    case StandardView::Superior:
      return sideName(scene, 2, true);
    case StandardView::Inferior:
      return sideName(scene, 2, false);
    case StandardView::Oblique:
      break;
  }
  return QObject::tr("oblique");
}

QString sideSign(const scene::Scene& scene, int axis, bool isPlus) {
  static constexpr const char* kPatient[3][2] = {{"R", "L"}, {"A", "P"}, {"I", "S"}};
  static constexpr const char* kAxis[3][2] = {{"-x", "+x"}, {"-y", "+y"}, {"-z", "+z"}};
  return (hasPatientLetters(scene) ? kPatient : kAxis)[axis][isPlus ? 1 : 0];
}

QString planeName(const scene::Scene& scene, scene::SectionKind kind) {
  static constexpr const char* kAxes[] = {"XY", "XZ", "YZ"};
  return hasPatientLetters(scene) ? sectionName(kind) : QString(kAxes[static_cast<int>(kind)]);
}

}  // namespace velum::gui
