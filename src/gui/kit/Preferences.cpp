#include "gui/kit/Preferences.h"

#include <QStandardPaths>
#include <algorithm>

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

namespace {

constexpr double kMebibyte = 1 << 20;

}  // namespace

MemoryBudget Preferences::memory() const {
  auto bytes = [this](const char* key, double fallback) {
    return std::max(0.0, mSettings.value(key, fallback / kMebibyte).toDouble()) * kMebibyte;
  };
  MemoryBudget usual;
  return {bytes("volumes/wholeMiB", usual.wholeBytes), bytes("volumes/brickMiB", usual.brickBytes),
          bytes("volumes/gpuBrickMiB", usual.gpuBrickBytes)};
}

void Preferences::setMemory(const MemoryBudget& budget) {
  setValue("volumes/wholeMiB", budget.wholeBytes / kMebibyte);
  setValue("volumes/brickMiB", budget.brickBytes / kMebibyte);
  setValue("volumes/gpuBrickMiB", budget.gpuBrickBytes / kMebibyte);
  setMemoryBudget(budget);
}

QString Preferences::folder() { return QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation); }

}  // namespace velum::gui
