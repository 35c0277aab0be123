#include "Preferences.h"

#include <QStandardPaths>

namespace velum::gui {

Preferences::Preferences() : mSettings(folder() + "/preferences.ini", QSettings::IniFormat) {}

ThemeKind Preferences::theme() const {
  return mSettings.value("theme").toString() == "light" ? ThemeKind::Light : ThemeKind::Dark;
}

void Preferences::setTheme(ThemeKind theme) {
  mSettings.setValue("theme", theme == ThemeKind::Light ? "light" : "dark");
}

QString Preferences::folder() { return QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation); }

}  // namespace velum::gui
