#pragma once
#include "view/Room.h"

namespace velum::gui {

/// Undo, redo, and the list of both; preferences.
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

  QAction *mUndo, *mRedo;
};

}  // namespace velum::gui
