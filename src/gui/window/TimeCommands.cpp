#include "gui/window/TimeCommands.h"

namespace velum::gui {

TimeCommands::TimeCommands(const WindowParts& parts, TimeBar& bar) : Room(parts), mBar(bar) {
  QMenu* menu = parts.menu(MenuId::Time);
  parts.actions.addForScene(menu, "time.play", tr("&Play or pause"), tr("Play the time steps round and round"),
                            [this] { mBar.setPlaying(!mBar.isPlaying()); });
  parts.actions.addForScene(menu, "time.next", tr("&Next step"), tr("The next time step"), [this] { mBar.step(1); });
  parts.actions.addForScene(menu, "time.previous", tr("&Step before"), tr("The time step before"),
                            [this] { mBar.step(-1); });
  connect(&mBar, &TimeBar::askReady, this, [this](bool& ready) { ready = mParts.views.isCurrent(); });
}

}  // namespace velum::gui
