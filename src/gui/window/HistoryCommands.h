#pragma once
#include "gui/view/Room.h"
#include "gui/window/CommandsWindow.h"

namespace velum::gui {

/// Undo, redo, and the list of both; the edits as commands of a script; preferences.
class HistoryCommands : public Room {
  Q_OBJECT
 public:
  explicit HistoryCommands(const WindowParts& parts);
  void refresh(const session::Session& session) override;

 signals:
  /// A preference has changed that decides how things are shown.
  void preferencesChanged();

 private:
  void askPreferences();
  void fillHistory(QMenu& menu);
  void copyLast();
  void copyPython();
  void showCommands();

  QAction *mUndo, *mRedo, *mCopy;
  CommandsWindow* mCommands = nullptr;  ///< Made when it is first shown; null before.
};

}  // namespace velum::gui
