#pragma once
#include <QSettings>

#include "Theme.h"

namespace velum::gui {

/// What the user has chosen for the program rather than for a scene: `preferences.ini` in velum's folder under
/// XDG_CONFIG_HOME.
class Preferences {
 public:
  Preferences();
  ThemeKind theme() const;
  void setTheme(ThemeKind theme);
  /// Other values, by key; for what one widget alone remembers.
  QVariant value(const QString& key, const QVariant& fallback = {}) const { return mSettings.value(key, fallback); }
  void setValue(const QString& key, const QVariant& value) { mSettings.setValue(key, value); }
  /// Where it is stored.
  QString path() const { return mSettings.fileName(); }
  /// Where it is stored, and the user's keys with it.
  static QString folder();

 private:
  QSettings mSettings;
};

}  // namespace velum::gui
