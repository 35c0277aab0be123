#pragma once
#include "gui/view/Room.h"
#include "gui/window/CommandsWindow.h"

namespace velum::gui {

/// Undo, redo, and the list of both; what was done as commands; preferences.
class HistoryCommands : public Room {
  Q_OBJECT
 public:
  explicit HistoryCommands(const WindowParts& parts);
  void refresh(const session::Session& session) override;

 signals:
  /// How things are shown has changed.
  void preferencesChanged();

 private:
  void askPreferences();
  void fillHistory(QMenu& menu);
  void copyLast();
  void showCommands();

  QAction *mUndo, *mRedo, *mCopy;
  CommandsWindow* mCommands = nullptr;  ///< From when it is first shown.
};

}  // namespace velum::gui
