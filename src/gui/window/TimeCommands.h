#pragma once
#include "gui/view/Room.h"
#include "gui/view/TimeBar.h"

namespace velum::gui {

/// The commands that play time steps.
class TimeCommands : public Room {
  Q_OBJECT
 public:
  TimeCommands(const WindowParts& parts, TimeBar& bar);
  void refresh(const session::Session&) override { mBar.refresh(); }

 private:
  TimeBar& mBar;
};

}  // namespace velum::gui
