#pragma once
#include "gui/look/FinishPanel.h"
#include "gui/look/LookCommands.h"
#include "gui/look/LookPanel.h"
#include "gui/view/Room.h"

namespace velum::gui {

/// What the data looks like: the panel of presets, curves and light; the panel of the finish; looks in files; "show
/// this".
class LookRoom : public Room {
  Q_OBJECT
 public:
  explicit LookRoom(const WindowParts& parts);
  void refresh(const session::Session&) override {
    mPanel->refresh();
    mFinish->refresh();
  }
  LookCommands& commands() { return *mCommands; }

 private:
  LookPanel* mPanel;
  FinishPanel* mFinish;
  LookCommands* mCommands;
};

}  // namespace velum::gui
