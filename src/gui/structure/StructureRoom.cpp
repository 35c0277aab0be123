#include "gui/structure/StructureRoom.h"

#include "session/command/StructureCommands.h"

namespace velum::gui {

StructureRoom::StructureRoom(const WindowParts& parts)
    : Room(parts),
      mCommands(new StructureCommands(parts.document(), parts.selection, this)),
      mAreas(new AreaMeter(parts.session, parts.views.viewport(), this)),
      mPanel(nullptr) {
  // Before the panel hears of it: a list that is not shown cannot be edited.
  connect(mCommands, &StructureCommands::renameAsked, this, [this] { mParts.tabs.showPage(mPanel); });
  mPanel = new StructurePanel(*mCommands, *mAreas, parts.selection, &parts.tabs);
  parts.tabs.addPage(mPanel, QT_TRANSLATE_NOOP("Words", "Structures"),
                     tr("Labelled structures: name, colour, opacity, what is shown"));
  connect(mPanel, &StructurePanel::openLabelsAsked, this, &StructureRoom::openLabelsAsked);
  connect(mPanel, &StructurePanel::smoothingAsked, this, &StructureRoom::smooth);
  connect(mAreas, &AreaMeter::failed, &parts.messages, &MessageBar::showError);
  connectViews();
  addActions();
}

void StructureRoom::smooth(const std::vector<int>& ids, double deviation) {
  mParts.jobs.run(session::SmoothStructures{session::structureNames(mParts.session.shown(), ids), deviation});
}

void StructureRoom::refresh(const session::Session& session) {
  // Beside a model alone there is nothing that could have labels, and the row of tabs is full.
  const scene::Scene& scene = session.shown();
  mIsModelAlone = scene.model.data && !scene.volume.data && !scene.labels.data;
  mParts.tabs.setPageShown(mPanel, !mIsModelAlone);
  mPanel->refresh();
  if (mPanel->isVisible()) mAreas->refresh();
}

void StructureRoom::connectViews() {
  Selection& selection = mParts.selection;
  Viewport& viewport = mParts.views.viewport();
  connect(&viewport, &Viewport::clickedAt, this,
          [&selection](const render::Pick& pick) { selection.setStructure(pick.hit ? pick.structure : 0); });
  auto showMenu = [this, &selection](int structure, QPoint place) {
    selection.setStructure(structure);
    QMenu menu(&mParts.window);
    mCommands->fillMenu(menu, {structure});
    menu.exec(place);
  };
  connect(&viewport, &Viewport::menuAskedAt, this, [showMenu](const render::Pick& pick, QPoint place) {
    if (pick.hit && pick.structure != 0) showMenu(pick.structure, place);
  });
  connect(&mParts.views, &ViewGrid::structureMenuAsked, this, showMenu);
}

void StructureRoom::addActions() {
  ActionTable& actions = mParts.actions;
  QMenu* menu = mParts.menu(MenuId::Structures);
  auto withSelected = [this](void (*act)(StructureCommands&, int, const scene::Scene&)) {
    return [this, act] {
      if (int id = mParts.selection.structure()) act(*mCommands, id, mParts.session.shown());
    };
  };
  actions.addForScene(menu, "structure.openLabels", tr("&Open labels beside..."),
                      tr("Choose a file of labels for what is open"), [this] { emit openLabelsAsked(); });
  actions.addForScene(menu, "structure.list", tr("&List"), tr("Show the list of structures"),
                      [this] { mParts.tabs.showPage(mPanel); });
  actions.addForScene(menu, "structure.find", tr("&Find..."), tr("Search a structure by name or number"), [this] {
    if (mIsModelAlone) return emit findAskedElsewhere();
    mParts.tabs.showPage(mPanel);
    mPanel->startSearch();
  });
  menu->addSeparator();
  actions.addForScene(menu, "structure.toggle", tr("&Hide or show"), tr("Hide the selected structure, or show it"),
                      withSelected([](StructureCommands& commands, int id, const scene::Scene& scene) {
                        if (const auto* found = session::findStructure(scene, id))
                          commands.setVisible({id}, !found->visible);
                      }));
  actions.addForScene(
      menu, "structure.solo", tr("&Solo"), tr("Show the selected structure alone, or what was shown before"),
      withSelected([](StructureCommands& commands, int id, const scene::Scene&) { commands.toggleSolo(id); }));
  actions.addForScene(menu, "structure.showAll", tr("Show &all"), tr("Show every structure"), [this] {
    std::vector<int> ids;
    for (const auto& structure : mParts.session.shown().labels.structures) ids.push_back(structure.id);
    mCommands->setVisible(ids, true);
  });
  actions.addForScene(
      menu, "structure.goTo", tr("&Go to"), tr("Bring the camera near and the crosshair into the selected structure"),
      withSelected([](StructureCommands& commands, int id, const scene::Scene&) { commands.goTo(id); }));
  actions.addForScene(menu, "structure.spare", tr("S&pare"),
                      tr("The selected cut spares the selected structure, or cuts it again"),
                      withSelected([](StructureCommands& commands, int id, const scene::Scene&) {
                        commands.setSpared({id}, !commands.isSpared(id));
                      }));
  menu->addSeparator();
  actions.addForScene(menu, "structure.export", tr("&Export..."),
                      tr("Write the selected structures as surfaces or as labels, for other programs"),
                      [this] { emit mCommands->exportAsked(selectedIds()); });
}

}  // namespace velum::gui
