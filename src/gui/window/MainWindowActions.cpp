// Menus, tool bar and dialogs of the main window.
#include <QFileDialog>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QStandardPaths>
#include <QToolBar>

#include "CommandFinder.h"
#include "HelpWindow.h"
#include "MainWindow.h"
#include "Preferences.h"
#include "SavePictureDialog.h"
#include "cut/CutPanel.h"
#include "cut/ThreePointTool.h"
#include "look/LookCommands.h"
#include "membrane/SheetTool.h"
#include "velum/session/document/Open.h"
#include "view/TimeBar.h"
#include "view/ViewChange.h"
#include "view/ViewIcons.h"

namespace velum::gui {

namespace {

QString openFilter() {
  QString all, single;
  for (const auto& kind : session::readableKinds()) {
    QString patterns;
    for (const auto& pattern : kind.patterns)
      patterns += (patterns.isEmpty() ? "" : " ") + QString::fromStdString(pattern);
    all += (all.isEmpty() ? "" : " ") + patterns;
    single += QString(";;%1 (%2)").arg(QString::fromStdString(kind.name), patterns);
  }
  return MainWindow::tr("All that Velum reads (%1)").arg(all) + ";;" + MainWindow::tr("All files (*)") + single;
}

}  // namespace

void MainWindow::buildActions() {
  auto* bar = new QToolBar(tr("Tools"), this);
  bar->setObjectName("toolBar");
  bar->setMovable(false);
  bar->setContextMenuPolicy(Qt::PreventContextMenu);
  addToolBar(bar);
  buildFileActions(menuBar()->addMenu(tr("&File")), bar);
  bar->addSeparator();
  buildEditActions(menuBar()->addMenu(tr("&Edit")), bar);
  bar->addSeparator();
  buildViewActions(menuBar()->addMenu(tr("&View")), bar);
  bar->addSeparator();
  mLookCommands = new LookCommands(mDocument, *mViews, *mMessages, this);
  mLookCommands->build(*mActions, menuBar()->addMenu(tr("&Look")), bar);
  bar->addSeparator();
  buildCutActions(menuBar()->addMenu(tr("&Cut")), bar);
  buildStructureActions(menuBar()->addMenu(tr("S&tructures")));
  buildTimeActions(menuBar()->addMenu(tr("&Time")));
  buildHelpActions(menuBar()->addMenu(tr("&Help")));
}

void MainWindow::buildTimeActions(QMenu* menu) {
  mActions->addForScene(menu, "time.play", tr("&Play or pause"), tr("Play the time steps round and round"),
                        [this] { mTime->setPlaying(!mTime->isPlaying()); });
  mActions->addForScene(menu, "time.next", tr("&Next step"), tr("The next time step"), [this] { mTime->step(1); });
  mActions->addForScene(menu, "time.previous", tr("&Step before"), tr("The time step before"),
                        [this] { mTime->step(-1); });
}

void MainWindow::buildHelpActions(QMenu* menu) {
  mActions->add(menu, "help.guide", tr("User &guide"), tr("Read the guide; no network is needed"),
                [this] { showHelp(); });
  mActions->add(menu, "help.find", tr("&Find a command..."), tr("Find any command by a few letters and do it"),
                [this] { findCommand(); });
  menu->addSeparator();
  mActions->add(menu, "help.about", tr("&About Velum"), tr("Say what Velum is"), [this] { showAbout(); });
}

void MainWindow::showHelp() {
  if (!mHelp) mHelp = new HelpWindow(this);
  mHelp->show();
  mHelp->raise();
  mHelp->activateWindow();
}

void MainWindow::findCommand() {
  CommandFinder finder(*mActions, this);
  finder.exec();
}

void MainWindow::showPreferences() {
  PreferencesDialog dialog(this);
  dialog.exec();
}

void MainWindow::buildFileActions(QMenu* menu, QToolBar* bar) {
  mActions->add(menu, "file.new", tr("&New"), tr("Close what is open"), [this] {
    if (mayLeaveScene()) newScene();
  });
  QAction* open = mActions->add(menu, "file.open", tr("&Open..."), tr("Open a volume, labels, surfaces or a scene"),
                                [this] { askOpen(false); });
  mActions->add(menu, "file.openFolder", tr("Open &folder..."), tr("Open a folder of DICOM slices"),
                [this] { askOpenFolder(); });
  buildDocumentActions(menu);
  mActions->addForScene(menu, "file.add", tr("&Add labels or surfaces..."), tr("Open beside what is open"),
                        [this] { askOpen(true); });
  QMenu* phantoms = menu->addMenu(tr("Make a &phantom"));
  for (const auto& sample : session::sampleNames()) {
    QString name = QString::fromStdString(sample);
    mActions->add(phantoms, "file.phantom." + name, name, tr("Compute the phantom %1 and its labels").arg(name),
                  [this, name] {
                    if (mayLeaveScene()) openPhantom(name, 0);
                  });
  }
  menu->addSeparator();
  mActions->addForScene(menu, "file.saveScene", tr("&Save scene"), tr("Save the scene"),
                        [this] { askSaveScene(false); });
  mActions->addForScene(menu, "file.saveSceneAs", tr("Save scene &as..."), tr("Save the scene under another name"),
                        [this] { askSaveScene(true); });
  QAction* picture = mActions->addForScene(menu, "file.savePicture", tr("Save p&icture..."),
                                           tr("Draw and save a picture of any size"), [this] { askSavePicture(); });
  buildExportActions(menu);
  menu->addSeparator();
  mActions->add(menu, "file.newWindow", tr("New &window"), tr("Open a second window with a scene of its own"), [this] {
    auto* window = new MainWindow;
    window->setAttribute(Qt::WA_DeleteOnClose);
    if (mJournal) window->protectWork(mRecoveryRoot, false);
    window->show();
  });
  mCancel = mActions->add(menu, "file.cancel", tr("&Cancel what is running"), tr("Stop the load or the picture"),
                          [this] { cancelJob(); });
  mCancel->setEnabled(false);
  mActions->add(menu, "file.quit", tr("&Quit"), tr("Leave Velum"), [this] { close(); });
  open->setIconText(tr("Open"));
  picture->setIconText(tr("Save picture"));
  bar->addAction(open);
  bar->addAction(picture);
}

void MainWindow::buildEditActions(QMenu* menu, QToolBar* bar) {
  mUndo = mActions->add(menu, "edit.undo", tr("&Undo"), tr("Take the last change back"), [this] { mDocument.undo(); });
  mRedo = mActions->add(menu, "edit.redo", tr("&Redo"), tr("Do it again"), [this] { mDocument.redo(); });
  buildHistory(menu);
  mUndo->setIconText(tr("Undo"));
  mRedo->setIconText(tr("Redo"));
  menu->addSeparator();
  mActions->add(menu, "edit.preferences", tr("&Preferences..."), tr("Appearance, and where settings are stored"),
                [this] { showPreferences(); });
  bar->addAction(mUndo);
  bar->addAction(mRedo);
}

void MainWindow::buildViewActions(QMenu* menu, QToolBar* bar) {
  using scene::StandardView;
  struct Row {
    const char *id, *name, *letter;
    StandardView view;
  };
  static constexpr Row kRows[] = {{"view.anterior", "&Anterior", "A", StandardView::Anterior},
                                  {"view.posterior", "&Posterior", "P", StandardView::Posterior},
                                  {"view.left", "&Left", "L", StandardView::Left},
                                  {"view.right", "&Right", "R", StandardView::Right},
                                  {"view.superior", "&Superior", "S", StandardView::Superior},
                                  {"view.inferior", "&Inferior", "I", StandardView::Inferior},
                                  {"view.oblique", "&Oblique", "", StandardView::Oblique}};
  for (const Row& row : kRows) {
    QAction* action =
        mActions->addForScene(menu, row.id, tr(row.name), tr("Look from: %1").arg(tr(row.name).remove('&').toLower()),
                              [this, view = row.view] { mViewport->lookFrom(view); });
    if (!*row.letter) continue;
    action->setIconText(row.letter);
    bar->addAction(action);
  }
  menu->addSeparator();
  mProjection = mActions->addForScene(menu, "view.parallel", tr("&Parallel projection"),
                                      tr("Parallel (orthographic) instead of perspective"),
                                      [this] { mViewport->toggleProjection(); });
  mProjection->setIconText(tr("Parallel"));
  mProjection->setCheckable(true);
  QAction* reset = mActions->addForScene(menu, "view.reset", tr("&Reset view"), tr("See all of it from the front"),
                                         [this] { mViewport->lookFrom(scene::defaultView(mDocument.scene())); });
  reset->setIconText(tr("Reset"));
  bar->addAction(mProjection);
  bar->addAction(reset);
  bar->addSeparator();
  menu->addSeparator();
  buildLayoutActions(menu, bar);
}

void MainWindow::buildLayoutActions(QMenu* menu, QToolBar* bar) {
  using scene::Layout;
  struct Row {
    const char *id, *name, *tip;
    ViewIcon icon;
  };
  // In the order of scene::Layout.
  static constexpr Row kRows[] = {
      {"layout.four", "&Four views", "Axial, coronal, sagittal and 3D", ViewIcon::FourUp},
      {"layout.volume", "3D &only", "The 3D view alone", ViewIcon::Volume},
      {"layout.beside", "3D and one &slice", "The 3D view and the current slice", ViewIcon::VolumeAndSlice},
      {"layout.slice", "One s&lice", "The current slice alone", ViewIcon::Slice}};
  mLayouts = new QActionGroup(this);
  for (int i = 0; i < 4; ++i) {
    const Row& row = kRows[i];
    QAction* action = mActions->addForScene(menu, row.id, tr(row.name), tr(row.tip),
                                            [this, i] { mViews->setLayout(static_cast<Layout>(i)); });
    action->setIcon(makeViewIcon(row.icon));
    action->setIconVisibleInMenu(false);
    action->setCheckable(true);
    mLayouts->addAction(action);
    bar->addAction(action);
  }
  menu->addSeparator();
  mActions->addForScene(menu, "slices.next", tr("&Next slice"), tr("Show the plane nearer to you"),
                        [this] { mViews->currentSlice().scroll(1); });
  mActions->addForScene(menu, "slices.previous", tr("Pre&vious slice"), tr("Show the plane further away"),
                        [this] { mViews->currentSlice().scroll(-1); });
  mActions->addForScene(menu, "slices.reset", tr("Slices along the patient's a&xes"),
                        tr("Axial, coronal and sagittal again, crosshair in the middle"),
                        [this] { changeSlices(mDocument, scene::resetSlices); });
}

void MainWindow::buildCutActions(QMenu* menu, QToolBar* bar) {
  QAction* add = mActions->addForScene(menu, "cut.addPlane", tr("&Add plane"), tr("Cut away the half that faces you"),
                                       [this] { mCuts->addPlane(); });
  mActions->addForScene(menu, "cut.alongView", tr("Cut along the &view"),
                        tr("A plane through the middle that faces you exactly"), [this] { mCuts->addAlongView(); });
  mActions->addForScene(menu, "cut.threePoints", tr("Plane through three &points"),
                        tr("Click three points in the picture"), [this] { mThreePoints->start(); });
  QAction* sheet =
      mActions->addForScene(menu, "cut.addMembrane", tr("Add &membrane"),
                            tr("An elastic sheet that cuts around what matters instead of through it"), [this] {
                              mCuts->addMembrane();
                              for (int i = 0; i < mTabs->count(); ++i)
                                if (mTabs->widget(i)->isAncestorOf(mCuts)) mTabs->setCurrentIndex(i);
                            });
  struct Row {
    const char *id, *name;
    scene::CutShape shape;
  };
  static constexpr Row kRows[] = {{"cut.addBox", "Add &box", scene::CutShape::Box},
                                  {"cut.addSphere", "Add &sphere", scene::CutShape::Sphere},
                                  {"cut.addCylinder", "Add c&ylinder", scene::CutShape::Cylinder},
                                  {"cut.addCone", "Add co&ne", scene::CutShape::Cone}};
  for (const Row& row : kRows)
    mActions->addForScene(menu, row.id, tr(row.name), tr("A third of the data in size, where it opens what you see"),
                          [this, shape = row.shape] { mCuts->addShape(shape); });
  menu->addSeparator();
  mActions->addForScene(menu, "membrane.pin", tr("P&in the sheet"),
                        tr("Click the sheet of the membrane and hold it there, or drag it on"),
                        [this] { mSheetTool->start(SheetTool::Mode::Pin); });
  mActions->addForScene(menu, "membrane.push", tr("Pu&sh kernel"),
                        tr("Drag a ball in a slice, or click in the picture: the sheet goes around it"),
                        [this] { mSheetTool->start(SheetTool::Mode::Push); });
  mActions->addForScene(menu, "membrane.pull", tr("Pu&ll kernel"),
                        tr("Drag a ball in a slice, or click in the picture: the sheet is drawn to its middle"),
                        [this] { mSheetTool->start(SheetTool::Mode::Pull); });
  menu->addSeparator();
  mActions->addForScene(menu, "cut.flip", tr("&Flip"), tr("Take away the other side"),
                        [this] { mCuts->flipSelected(); });
  mActions->addForScene(menu, "cut.duplicate", tr("&Duplicate"), tr("Add a copy of the selected cut"),
                        [this] { mCuts->duplicateSelected(); });
  mActions->addForScene(menu, "cut.remove", tr("&Remove"), tr("Remove the selected cut"),
                        [this] { mCuts->removeSelected(); });
  add->setIconText(tr("Add cut"));
  sheet->setIconText(tr("Membrane"));
  bar->addAction(add);
  bar->addAction(sheet);
}

void MainWindow::askOpen(bool add) {
  QStringList paths = QFileDialog::getOpenFileNames(
      this, tr("Open"), mPath.isEmpty() ? QString() : QFileInfo(mPath).path(), openFilter());
  openAsked(paths, add);
}

void MainWindow::askOpenFolder() {
  QString path = QFileDialog::getExistingDirectory(this, tr("Open a folder of DICOM slices"),
                                                   mPath.isEmpty() ? QString() : QFileInfo(mPath).path());
  if (!path.isEmpty()) openAsked({path});
}

QString MainWindow::pictureFolder() const {
  QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
  return pictures.isEmpty() ? QString() : pictures + "/";
}

void MainWindow::askSavePicture() {
  double ratio = mViewport->devicePixelRatioF();
  SavePictureDialog dialog({int(mViewport->width() * ratio), int(mViewport->height() * ratio)}, mDocument.scene(),
                           this);
  if (dialog.exec() != QDialog::Accepted) return;
  QString start = pictureFolder() + QFileInfo(mPath).baseName() + (dialog.options().layers ? ".exr" : ".png");
  QString path =
      QFileDialog::getSaveFileName(this, tr("Save picture"), start, tr("PNG (*.png);;OpenEXR (*.exr);;TIFF (*.tif)"));
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += ".png";
  savePictureTo(path, dialog.options(), dialog.pictureScene());
}

void MainWindow::askSaveScene(bool asNew) {
  QString path = mScenePath;
  if (asNew || path.isEmpty()) {
    QString start = QFileInfo(mPath).path() + "/" + QFileInfo(mPath).baseName() + ".json";
    path = QFileDialog::getSaveFileName(this, tr("Save scene"), start, tr("Velum scene (*.json)"));
    if (path.isEmpty()) return;
    if (QFileInfo(path).suffix().isEmpty()) path += ".json";
  }
  saveSceneTo(path);
}

void MainWindow::showAbout() {
  QMessageBox::about(this, tr("About Velum"),
                     tr("<h3>Velum %1</h3><p>Volumes, cut open the way illustrators do.</p>"
                        "<p><b>Not a medical device.</b> Do not use it for diagnosis or treatment.</p>")
                         .arg(VELUM_VERSION));
}

}  // namespace velum::gui
