// The main window's wiring of structures: their panel, menu, what a click in the 3D view does.
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QScrollArea>

#include "MainWindow.h"
#include "cut/CutPanel.h"
#include "cut/ThreePointTool.h"
#include "structure/StructurePanel.h"
#include "velum/session/document/Open.h"

namespace velum::gui {

void MainWindow::buildStructures() {
  mStructureCommands = new StructureCommands(mDocument, *mSelection, this);
  // Before the panel hears of it: a list that is not shown cannot be edited.
  connect(mStructureCommands, &StructureCommands::renameAsked, this,
          [this] { mActions->find("structure.list")->trigger(); });
  mStructures = new StructurePanel(*mStructureCommands, *mSelection, mTabs);
  addTab(mStructures, tr("Structures"), tr("Labelled structures: name, colour, opacity, what is shown"));
  mThreePoints = new ThreePointTool(mDocument, *mViewport);
  connect(mStructures, &StructurePanel::openLabelsAsked, this, &MainWindow::askOpenLabels);
  connect(mCuts, &CutPanel::threePointsAsked, mThreePoints, &ThreePointTool::start);
  connect(mThreePoints, &ThreePointTool::ended, this, [this] { mViewport->selectCut(mSelection->cut()); });
  connect(mSelection, &Selection::cutChanged, mThreePoints, &ThreePointTool::cancel);
  connect(mThreePoints, &ThreePointTool::made, this,
          [this](const scene::Cut& cut) { mCuts->addCut(cut, "Plane through three points"); });
  connect(mViewport, &Viewport::clickedAt, this, [this](const render::Pick& pick) {
    if (!mThreePoints->isActive()) mSelection->setStructure(pick.hit ? pick.structure : 0);
  });
  auto showMenu = [this](int structure, QPoint place) {
    mSelection->setStructure(structure);
    QMenu menu(this);
    mStructureCommands->fillMenu(menu, {structure});
    menu.exec(place);
  };
  connect(mViewport, &Viewport::menuAskedAt, this, [showMenu](const render::Pick& pick, QPoint place) {
    if (pick.hit && pick.structure != 0) showMenu(pick.structure, place);
  });
  connect(mViews, &ViewGrid::structureMenuAsked, this, showMenu);
}

void MainWindow::buildStructureActions(QMenu* menu) {
  auto withSelected = [this](void (*act)(StructureCommands&, int, const scene::Scene&)) {
    return [this, act] {
      if (int id = mSelection->structure()) act(*mStructureCommands, id, mDocument.scene());
    };
  };
  auto showTab = [this] {
    for (int i = 0; i < mTabs->count(); ++i)
      if (mTabs->widget(i)->isAncestorOf(mStructures)) mTabs->setCurrentIndex(i);
  };
  mActions->addForScene(menu, "structure.openLabels", tr("&Open labels beside..."),
                        tr("Choose a file of labels for what is open"), [this] { askOpenLabels(); });
  mActions->addForScene(menu, "structure.list", tr("&List"), tr("Show the list of structures"), showTab);
  mActions->addForScene(menu, "structure.find", tr("&Find..."), tr("Search a structure by name or number"),
                        [this, showTab] {
                          showTab();
                          mStructures->startSearch();
                        });
  menu->addSeparator();
  mActions->addForScene(menu, "structure.toggle", tr("&Hide or show"), tr("Hide the selected structure, or show it"),
                        withSelected([](StructureCommands& commands, int id, const scene::Scene& scene) {
                          if (const auto* found = session::findStructure(scene, id))
                            commands.setVisible({id}, !found->visible);
                        }));
  mActions->addForScene(
      menu, "structure.solo", tr("&Solo"), tr("Show the selected structure alone, or what was shown before"),
      withSelected([](StructureCommands& commands, int id, const scene::Scene&) { commands.toggleSolo(id); }));
  mActions->addForScene(menu, "structure.showAll", tr("Show &all"), tr("Show every structure"), [this] {
    std::vector<int> ids;
    for (const auto& structure : mDocument.scene().labels.structures) ids.push_back(structure.id);
    mStructureCommands->setVisible(ids, true);
  });
  mActions->addForScene(
      menu, "structure.goTo", tr("&Go to"), tr("Bring the camera near and the crosshair into the selected structure"),
      withSelected([](StructureCommands& commands, int id, const scene::Scene&) { commands.goTo(id); }));
  mActions->addForScene(menu, "structure.keepWhole", tr("&Keep whole"),
                        tr("The selected cut leaves the selected structure whole, or cuts it again"),
                        withSelected([](StructureCommands& commands, int id, const scene::Scene&) {
                          commands.setKeptWhole({id}, !commands.isKeptWhole(id));
                        }));
}

void MainWindow::askOpenLabels() {
  QStringList patterns;
  for (const auto& kind : session::volumeKinds())
    for (const auto& pattern : kind.patterns) patterns << QString::fromStdString(pattern);
  QString path = QFileDialog::getOpenFileName(this, tr("Open labels beside what is open"),
                                              mPath.isEmpty() ? QString() : QFileInfo(mPath).path(),
                                              tr("Labels (%1)").arg(patterns.join(' ')) + ";;" + tr("All files (*)"));
  if (!path.isEmpty()) openLabels(path);
}

void MainWindow::openLabels(const QString& path) {
  scene::Source source;
  source.path = QFileInfo(path).absoluteFilePath().toStdString();
  startLoad(
      tr("Opening %1").arg(QFileInfo(path).fileName()),
      [source](Loaded& loaded, Progress& progress) { session::addLabels(loaded.scene, source, progress); }, true, path);
}

}  // namespace velum::gui
