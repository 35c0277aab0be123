#include "gui/extrusion/ExtrusionRoom.h"

#include "session/command/Command.h"
#include "session/command/GrowthCommands.h"

namespace velum::gui {

ExtrusionRoom::ExtrusionRoom(const WindowParts& parts)
    : Room(parts),
      mPanel(new ExtrusionPanel(parts.session, parts.selection, &parts.tabs)),
      mPull(parts),
      mBarrier(parts) {
  parts.tabs.addPage(mPanel, QT_TRANSLATE_NOOP("Words", "Pull out"), tr("Structures that stand out of the cuts"));
  parts.toolbox.bind(mPull, mPanel->pullButton());
  parts.toolbox.bind(mBarrier, mPanel->barrierButton());
  connect(mPanel, &ExtrusionPanel::refused, &parts.messages,
          [&bar = parts.messages](const QString& why) { bar.showNote(why); });
  connect(mPanel, &ExtrusionPanel::held, &parts.messages,
          [&bar = parts.messages](const QString& why) { bar.showNote(why); });
  connect(mPanel, &ExtrusionPanel::notThisAsked, this, [this] {
    mParts.toolbox.start(mPull);
    mPull.askWhatIsNotOfIt();
  });
  connect(&mPanel->steps(), &PullSteps::asked, this, &ExtrusionRoom::takeStep);
  connect(&mPull, &PullTool::stopGrowingAsked, this, &ExtrusionRoom::stopGrowing);
  connect(&mPull, &Tool::activeChanged, this, [this](bool active) {
    if (active) mParts.tabs.showPage(mPanel);
  });
  connect(&parts.views.viewport(), &Viewport::playersHeard, this, &ExtrusionRoom::tell);
  addActions();
}

void ExtrusionRoom::refresh(const session::Session&) { mPanel->refresh(); }

void ExtrusionRoom::takeStep(PullSteps::Step step) {
  const auto& cuts = mParts.session.shown().cuts;
  switch (step) {
    case PullSteps::Step::Cut:
      if (cuts.empty()) mParts.actions.find("cut.addPlane")->trigger();
      mParts.tabs.showPage("Cuts");
      break;
    case PullSteps::Step::Pull:
      mParts.toolbox.start(mPull);
      break;
    case PullSteps::Step::Finish:
      mParts.tabs.showPage("Finish");
      break;
    case PullSteps::Step::Save:
      mParts.actions.find("file.savePicture")->trigger();
  }
}

/// Why nothing grows, once.
void ExtrusionRoom::tell() {
  std::string error = mParts.session.growth().status().error;
  if (error != mTold && !error.empty()) mParts.messages.showError(QString::fromStdString(error));
  mTold = error;
}

/// What has grown so far stays.
void ExtrusionRoom::stopGrowing() {
  if (!mParts.session.growth().stop()) return;
  mParts.jobs.run(session::StopGrowing{});
  mParts.messages.showNote(tr("Growing has stopped; what was found so far stays."));
}

void ExtrusionRoom::addActions() {
  QMenu* menu = mParts.menu(MenuId::Cut);
  menu->addSeparator();
  QAction* pull = mParts.actions.addForScene(menu, "extrusion.pull", tr("Pull &out structures"),
                                             tr("Drag a bone, a vessel or an organ out of the cut"), [] {});
  mParts.toolbox.bind(mPull, *pull);
  mParts.actions.addForScene(menu, "extrusion.secondPlane", tr("Second plane (&wedge)"),
                             tr("A plane across the selected one: the two open a wedge"),
                             [this] { mPanel->addPlane(); });
  mParts.actions.addForScene(menu, "extrusion.allBack", tr("Put all bac&k"), tr("Everything goes back into the cuts"),
                             [this] { mPanel->putAllBack(); });
  pull->setIconText(tr("Pull out"));
}

}  // namespace velum::gui
