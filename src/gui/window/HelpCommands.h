#pragma once
#include "gui/view/Room.h"

namespace velum::gui {

class HelpWindow;

/// The guide, the finder of commands, what Velum is.
class HelpCommands : public Room {
  Q_OBJECT
 public:
  explicit HelpCommands(const WindowParts& parts);

 private:
  void showGuide();
  void showAbout();

  HelpWindow* mGuide = nullptr;
};

}  // namespace velum::gui
