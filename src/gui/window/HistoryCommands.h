#pragma once
#include "view/Room.h"

namespace velum::gui {

/// Undo, redo, and the list of both; preferences.
class HistoryCommands : public Room {
  Q_OBJECT
 public:
  explicit HistoryCommands(const WindowParts& parts);
  void refresh(const session::Session& session) override;

 private:
  void fillHistory(QMenu& menu);

  QAction *mUndo, *mRedo;
};

}  // namespace velum::gui
