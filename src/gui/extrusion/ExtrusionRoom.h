#pragma once
#include "gui/extrusion/BarrierTool.h"
#include "gui/extrusion/ExtrusionPanel.h"
#include "gui/extrusion/PullTool.h"
#include "gui/view/Room.h"

namespace velum::gui {

/// Pulling structures out of cuts ([ACS]): the page, the tools, the commands.
class ExtrusionRoom : public Room {
  Q_OBJECT
 public:
  explicit ExtrusionRoom(const WindowParts& parts);
  void refresh(const session::Session&) override;

 private:
  void addActions();
  void takeStep(PullSteps::Step step);
  void stopGrowing();
  void tell();

  ExtrusionPanel* mPanel;
  PullTool mPull;
  BarrierTool mBarrier;
  std::string mTold;
};

}  // namespace velum::gui
