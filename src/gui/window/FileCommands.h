#pragma once
#include "gui/view/Room.h"
#include "gui/window/CarryCommands.h"
#include "gui/window/ExportCommands.h"
#include "gui/window/FileLoads.h"

namespace velum::gui {

/// The File menu: opens, saves and closes files, and asks before work is lost.
class FileCommands : public Room {
  Q_OBJECT
 public:
  FileCommands(const WindowParts& parts, FileLoads& loads, ExportCommands& exports, CarryCommands& carries);

  /// Asks about unsaved changes. @return true when the open scene is saved, or the user gives its changes up
  bool mayLeave();
  /// Opens files, and asks first where unsaved changes would be lost. @param add  to the open scene, instead of in its
  /// place
  void openAsked(const QStringList& paths, bool add = false);
  void saveSceneTo(const QString& path);
  /// Back to the empty window.
  void newScene();

 public slots:
  void askOpen(bool add);
  void askOpenFolder();
  void askOpenLabels();

 signals:
  void newWindowAsked();

 private:
  void addOpening(QMenu* menu);
  void addPhantoms(QMenu* menu);
  void addSaving(QMenu* menu);
  void askSaveScene(bool asNew);
  QString folder() const;

  FileLoads& mLoads;
  ExportCommands& mExports;
  CarryCommands& mCarries;
};

}  // namespace velum::gui
