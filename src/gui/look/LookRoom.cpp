#include "gui/look/LookRoom.h"

namespace velum::gui {

LookRoom::LookRoom(const WindowParts& parts)
    : Room(parts),
      mPanel(new LookPanel(parts.document(), &parts.tabs)),
      mFinish(new FinishPanel(parts.document(), &parts.tabs)),
      mCommands(new LookCommands(parts.document(), parts.toolbox, parts.messages, &parts.window)) {
  parts.tabs.addPage(mPanel, QT_TRANSLATE_NOOP("Words", "Look"), tr("Preset, rendering, light and background"));
  parts.tabs.addPage(mFinish, QT_TRANSLATE_NOOP("Words", "Finish"), tr("Contours, lit spheres, strokes and paper"));
  connect(&mFinish->spheres(), &LitSphereGrid::failed, &parts.messages, &MessageBar::showError);
  connect(mFinish, &FinishPanel::failed, &parts.messages, &MessageBar::showError);
  mCommands->build(parts.actions, parts.menu(MenuId::Look));
  connect(&parts.views.viewport(), &Viewport::refined, mPanel, [this](double, const QString& stage) {
    if (stage.isEmpty()) mPanel->viewIsComplete();
  });
  connect(&parts.views.viewport(), &Viewport::refined, mFinish, [this](double, const QString& stage) {
    if (stage.isEmpty()) mFinish->viewIsComplete();
  });
  connect(&parts.views, &ViewGrid::pointedAt, mPanel,
          [this](const render::Pick& pick) { mPanel->setProbe(pick.value); });
  connect(&parts.views, &ViewGrid::pointedAtNothing, mPanel, &LookPanel::clearProbe);
}

}  // namespace velum::gui
