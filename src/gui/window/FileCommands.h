#pragma once
#include "gui/view/Room.h"
#include "gui/window/ExportCommands.h"
#include "gui/window/FileLoads.h"

namespace velum::gui {

/// The File menu: what is opened, saved, closed, and what is asked before work is lost.
class FileCommands : public Room {
  Q_OBJECT
 public:
  FileCommands(const WindowParts& parts, FileLoads& loads, ExportCommands& exports);

  /// True when what is open is saved, or given up.
  bool mayLeave();
  /// Asks first where something would be lost.
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
};

}  // namespace velum::gui
