#pragma once
#include "gui/timeline/TimelineRoom.h"
#include "gui/view/Room.h"
#include "gui/view/TimeBar.h"

namespace velum::gui {

/// The commands that play and step, whatever plays: through the film while one is shown, else through the time steps of
/// a series.
class TimeCommands : public Room {
  Q_OBJECT
 public:
  TimeCommands(const WindowParts& parts, TimeBar& bar);
  /// Says who has the film; it comes later, as its strip has buttons of these commands.
  void follow(TimelineRoom& timeline) { mTimeline = &timeline; }
  void refresh(const session::Session& session) override;

 private:
  bool hasFilm() const { return mTimeline && mTimeline->hasFilm(); }
  void play();
  void step(int steps);

  TimeBar& mBar;
  TimelineRoom* mTimeline = nullptr;
};

}  // namespace velum::gui
