#include "gui/kit/CutTitle.h"

#include <QCoreApplication>

#include "gui/kit/Words.h"
#include "scene/Scene.h"
#include "session/cut/ShapeTraits.h"

namespace velum::gui {

namespace {

constexpr const char* kCopy = QT_TRANSLATE_NOOP("velum::gui::CutTitle", "%1 copy");
constexpr const char* kWay = QT_TRANSLATE_NOOP("velum::gui::CutTitle", "Way to %1");
constexpr const char* kUnnamed = QT_TRANSLATE_NOOP("velum::gui::CutTitle", "Cut %1");

QString ofTitle(const char* text) { return QCoreApplication::translate("velum::gui::CutTitle", text); }

/// A name that the program has given, in the window's language; a name of the user's as it is.
QString givenName(const QString& name) {
  const QString copy = " copy", way = "Way to ";
  if (name.endsWith(copy)) return ofTitle(kCopy).arg(givenName(name.chopped(copy.size())));
  if (name.startsWith(way)) return ofTitle(kWay).arg(name.mid(way.size()));
  QString title = name.section(' ', 0, -2), number = name.section(' ', -1);
  bool isNumbered = false;
  number.toInt(&isNumbered);
  if (!isNumbered) title = name;
  for (const session::ShapeTraits& shape : session::allShapes())
    if (title == shape.title) return isNumbered ? wordsOf(shape.title) + ' ' + number : wordsOf(shape.title);
  return name;
}

}  // namespace

QString cutTitle(const scene::Cut& cut, int index) {
  if (!cut.name.empty()) return givenName(QString::fromStdString(cut.name));
  return ofTitle(kUnnamed).arg(index + 1);
}

QString cutTitle(const scene::Scene& scene, int id) {
  const scene::Cut* cut = scene::findCut(scene, id);
  return cut ? cutTitle(*cut, scene::cutPlace(scene, id)) : QString();
}

}  // namespace velum::gui
