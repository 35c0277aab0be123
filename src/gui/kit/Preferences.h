#pragma once
#include <QSettings>

#include "gui/kit/Theme.h"

namespace velum::gui {

/// How the hand works in the views, and how lengths are told. Asked at each event and each number: kept in memory.
struct Habits {
  bool wheelForwardComesNearer = true;  ///< In the 3D view; false: it goes away.
  bool wheelGoesThroughPlanes = true;   ///< In sections, with Ctrl nearer; false: the other way round.
  bool leftTurns = true;                ///< In the 3D view, the middle button moves; false: the other way round.
  QString lengthUnit;                   ///< "mm", "\u00b5m", "nm", "\u00c5"; empty: what suits the data.
};

/// What the user has chosen for the program rather than for a scene: `preferences.ini` in velum's folder under
/// XDG_CONFIG_HOME.
class Preferences {
 public:
  Preferences();
  ThemeKind theme() const;
  void setTheme(ThemeKind theme);
  /// Of all windows.
  static const Habits& habits();
  void setHabits(const Habits& habits);
  /// In which data opens: a name of scene::Layout; empty: the last one used.
  QString firstLayout() const { return mSettings.value("view/firstLayout").toString(); }
  void setFirstLayout(const QString& name) { mSettings.setValue("view/firstLayout", name); }
  /// MiB of the graphics card that are used at most, from the next start on; 0: what the card has.
  int graphicsMemory() const { return mSettings.value("graphicsMemoryMiB", 0).toInt(); }
  void setGraphicsMemory(int mebibytes) { mSettings.setValue("graphicsMemoryMiB", mebibytes); }
  /// Other values, by key; for what one widget alone remembers.
  QVariant value(const QString& key, const QVariant& fallback = {}) const { return mSettings.value(key, fallback); }
  void setValue(const QString& key, const QVariant& value) { mSettings.setValue(key, value); }
  /// Where it is stored.
  QString path() const { return mSettings.fileName(); }
  /// Where it is stored, and the user's keys with it.
  static QString folder();
  static QString keysPath() { return folder() + "/keys.json"; }

 private:
  QSettings mSettings;
};

}  // namespace velum::gui
