// Menus, tool bar and dialogs of the main window.
#include <QFileDialog>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QStandardPaths>
#include <QToolBar>

#include "CommandFinder.h"
#include "CutPanel.h"
#include "HelpWindow.h"
#include "LookCommands.h"
#include "MainWindow.h"
#include "Preferences.h"
#include "SavePictureDialog.h"
#include "TimeBar.h"
#include "velum/session/Open.h"

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
  mLookCommands = new LookCommands(mDocument, *mViewport, *mMessages, this);
  mLookCommands->build(*mActions, menuBar()->addMenu(tr("&Look")), bar);
  bar->addSeparator();
  buildCutActions(menuBar()->addMenu(tr("&Cut")), bar);
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
}

void MainWindow::buildCutActions(QMenu* menu, QToolBar* bar) {
  QAction* add = mActions->addForScene(menu, "cut.addPlane", tr("&Add plane"), tr("Cut away the half that faces you"),
                                       [this] { mCuts->addPlane(); });
  mActions->addForScene(menu, "cut.flip", tr("&Flip"), tr("Take away the other side"),
                        [this] { mCuts->flipSelected(); });
  mActions->addForScene(menu, "cut.remove", tr("&Remove"), tr("Remove the selected cut"),
                        [this] { mCuts->removeSelected(); });
  add->setIconText(tr("Add cut"));
  bar->addAction(add);
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
