#pragma once
#include "gui/view/Room.h"
#include "session/command/DocumentCommands.h"

namespace velum::gui {

/// Takes the scene and its film over to other data.
class CarryCommands : public Room {
  Q_OBJECT
 public:
  explicit CarryCommands(const WindowParts& parts) : Room(parts) {}
  /// Adds the command where it stands in the File menu.
  void addAction(QMenu* menu);
  void refresh(const session::Session& session) override;
  /// Reads the other data in the background. What is changed in the scene meanwhile is carried over, too.
  void carry(const session::CarryScene& call);

 private:
  void ask();

  QAction* mCarry = nullptr;
};

}  // namespace velum::gui
