#include "gui/window/TimeCommands.h"

#include "gui/kit/Icons.h"

namespace velum::gui {

TimeCommands::TimeCommands(const WindowParts& parts, TimeBar& bar) : Room(parts), mBar(bar) {
  QMenu* menu = parts.menu(MenuId::Time);
  parts.actions.addForScene(menu, "time.play", tr("&Play or pause"), tr("Play the film, or the time steps of a series"),
                            [this] { play(); });
  parts.actions.addForScene(menu, "time.next", tr("&Next step"), tr("The next time step, or the next key of a film"),
                            [this] { step(1); });
  parts.actions.addForScene(menu, "time.previous", tr("&Step before"),
                            tr("The time step before, or the key before of a film"), [this] { step(-1); });
  connect(&parts.player, &Player::changed, this, [this] {
    mParts.actions.find("time.play")->setIcon(makeIcon(mParts.player.isPlaying() ? "film.pause" : "time.play"));
  });
}

void TimeCommands::refresh(const session::Session&) {
  mBar.setReplaced(mTimeline && mTimeline->hasTimeSteps());
  mBar.refresh();
  mParts.player.refresh();
}

void TimeCommands::play() {
  if (mParts.player.isPlaying()) return mParts.player.stop();
  hasFilm() ? mTimeline->setPlaying(true) : mBar.setPlaying(true);
}

void TimeCommands::step(int steps) { hasFilm() ? mTimeline->goToKey(steps) : mBar.step(steps); }

}  // namespace velum::gui
