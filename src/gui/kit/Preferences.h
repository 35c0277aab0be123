#pragma once
#include <QSettings>

#include "core/Memory.h"
#include "gui/kit/Theme.h"

namespace velum::gui {

/// How mouse and wheel work in the views, and in which unit lengths are shown. Kept in memory, as they are read at each
/// event and for each number.
struct Habits {
  bool wheelForwardComesNearer = true;  ///< In the 3D view; false: the camera goes farther away.
  bool wheelGoesThroughPlanes = true;   ///< In sections, with Ctrl nearer; false: the other way round.
  bool leftTurns = true;                ///< In the 3D view, the middle button moves; false: the other way round.
  QString lengthUnit;                   ///< "mm", "\u00b5m", "nm", "\u00c5"; empty: the unit that suits the data.
};

/// What the user has chosen for the program rather than for a scene: `preferences.ini` in velum's folder under
/// XDG_CONFIG_HOME.
class Preferences {
 public:
  Preferences();
  ThemeKind theme() const;
  void setTheme(ThemeKind theme);
  /// A code of languages(), from the next start on; empty: the system's.
  QString language() const { return mSettings.value("language").toString(); }
  void setLanguage(const QString& code) { mSettings.setValue("language", code); }
  /// The habits, which are the same for all windows.
  static const Habits& habits();
  void setHabits(const Habits& habits);
  /// The layout in which data opens: a name of scene::Layout; empty: the layout that was used last.
  QString firstLayout() const { return mSettings.value("view/firstLayout").toString(); }
  void setFirstLayout(const QString& name) { mSettings.setValue("view/firstLayout", name); }
  /// MiB of the graphics card that are used at most, from the next start on; 0: what the card has.
  int graphicsMemory() const { return mSettings.value("graphicsMemoryMiB", 0).toInt(); }
  void setGraphicsMemory(int mebibytes) { mSettings.setValue("graphicsMemoryMiB", mebibytes); }
  /// What volumes of any size may take; zeros as MemoryBudget says.
  MemoryBudget memory() const;
  /// Keeps a budget, which counts at once, and in the next start.
  void setMemory(const MemoryBudget& budget);
  /// The level at which volumes with levels of detail open, 0 the finest; -1: streamed or whole, as their size asks.
  int level() const { return mSettings.value("volumeLevel", -1).toInt(); }
  void setLevel(int level) { mSettings.setValue("volumeLevel", level); }
  /// Other values, by key; for what one widget alone remembers.
  QVariant value(const QString& key, const QVariant& fallback = {}) const { return mSettings.value(key, fallback); }
  void setValue(const QString& key, const QVariant& value) { mSettings.setValue(key, value); }
  /// The file in which the preferences are stored.
  QString path() const { return mSettings.fileName(); }
  /// The folder of the file of preferences and of the user's keys.
  static QString folder();
  static QString keysPath() { return folder() + "/keys.json"; }

 private:
  QSettings mSettings;
};

}  // namespace velum::gui
