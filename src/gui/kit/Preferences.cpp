#include "gui/kit/Preferences.h"

#include <QStandardPaths>

namespace velum::gui {

Preferences::Preferences() : mSettings(folder() + "/preferences.ini", QSettings::IniFormat) {}

ThemeKind Preferences::theme() const {
  return mSettings.value("theme").toString() == "light" ? ThemeKind::Light : ThemeKind::Dark;
}

void Preferences::setTheme(ThemeKind theme) {
  mSettings.setValue("theme", theme == ThemeKind::Light ? "light" : "dark");
}

namespace {

Habits readHabits() {
  Preferences stored;
  Habits habits;
  habits.wheelForwardComesNearer = stored.value("wheel/forwardComesNearer", true).toBool();
  habits.wheelGoesThroughPlanes = stored.value("wheel/goesThroughPlanes", true).toBool();
  habits.leftTurns = stored.value("mouse/leftTurns", true).toBool();
  habits.lengthUnit = stored.value("lengthUnit").toString();
  return habits;
}

Habits& keptHabits() {
  static Habits habits = readHabits();
  return habits;
}

}  // namespace

const Habits& Preferences::habits() { return keptHabits(); }

void Preferences::setHabits(const Habits& habits) {
  keptHabits() = habits;
  setValue("wheel/forwardComesNearer", habits.wheelForwardComesNearer);
  setValue("wheel/goesThroughPlanes", habits.wheelGoesThroughPlanes);
  setValue("mouse/leftTurns", habits.leftTurns);
  setValue("lengthUnit", habits.lengthUnit);
}

QString Preferences::folder() { return QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation); }

}  // namespace velum::gui
