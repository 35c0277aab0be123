#pragma once
#include <QDir>
#include <QWidget>

namespace velum::gui {

/// Saves how a widget looks as NAME.png in the folder that VELUM_SHOTS names, where it is set: to be looked at, and for
/// the pictures of the user guide.
inline void takeShot(QWidget& widget, const QString& name) {
  QString folder = qEnvironmentVariable("VELUM_SHOTS");
  if (folder.isEmpty()) return;
  QDir().mkpath(folder);
  widget.grab().save(folder + "/" + name + ".png");
}

}  // namespace velum::gui
