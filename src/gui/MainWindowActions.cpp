// Menus, tool bar and dialogs of the main window.
#include <QFileDialog>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QStandardPaths>
#include <QToolBar>

#include "CutPanel.h"
#include "MainWindow.h"
#include "SavePictureDialog.h"
#include "velum/session/Open.h"

namespace velum::gui {

namespace {

/// A tooltip that names the shortcut, too.
void setTip(QAction* action, const QString& tip) {
  QString keys = action->shortcut().toString(QKeySequence::NativeText);
  action->setToolTip(keys.isEmpty() ? tip : QString("%1 (%2)").arg(tip, keys));
}

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
  auto add = [this](QMenu* menu, const QString& text, const QKeySequence& keys, const QString& tip, auto&& slot) {
    QAction* action = menu->addAction(text);
    action->setShortcut(keys);
    setTip(action, tip);
    connect(action, &QAction::triggered, this, slot);
    return action;
  };

  QMenu* file = menuBar()->addMenu(tr("&File"));
  QAction* open = add(file, tr("&Open..."), QKeySequence::Open, tr("Open a volume, labels, surfaces or a scene"),
                      [this] { askOpen(false); });
  add(file, tr("Open &folder..."), QKeySequence("Ctrl+Shift+O"), tr("Open a folder of DICOM slices"),
      [this] { askOpenFolder(); });
  QAction* beside = add(file, tr("&Add labels or surfaces..."), QKeySequence("Ctrl+Alt+O"),
                        tr("Open beside what is open"), [this] { askOpen(true); });
  QMenu* phantoms = file->addMenu(tr("Make a &phantom"));
  for (const auto& sample : session::sampleNames()) {
    auto name = QString::fromStdString(sample);
    connect(phantoms->addAction(QString(name).replace('-', ' ')), &QAction::triggered, this,
            [this, name] { openPhantom(name, 0); });
  }
  file->addSeparator();
  QAction* saveScene =
      add(file, tr("&Save scene"), QKeySequence::Save, tr("Save the scene"), [this] { askSaveScene(false); });
  QAction* saveAs = add(file, tr("Save scene &as..."), QKeySequence("Ctrl+Shift+S"),
                        tr("Save the scene under another name"), [this] { askSaveScene(true); });
  QAction* picture = add(file, tr("Save p&icture..."), QKeySequence("Ctrl+E"),
                         tr("Draw and save a picture of any size"), [this] { askSavePicture(); });
  file->addSeparator();
  mCancel = add(file, tr("&Cancel what is running"), QKeySequence(Qt::Key_Escape), tr("Stop the load or the picture"),
                [this] { cancelJob(); });
  mCancel->setEnabled(false);
  add(file, tr("&Quit"), QKeySequence::Quit, tr("Leave Velum"), [this] { close(); });

  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  mUndo = add(edit, tr("&Undo"), QKeySequence::Undo, tr("Take the last change back"), [this] { mDocument.undo(); });
  mRedo = add(edit, tr("&Redo"), QKeySequence::Redo, tr("Do it again"), [this] { mDocument.redo(); });
  mUndo->setIconText(tr("Undo"));
  mRedo->setIconText(tr("Redo"));

  open->setIconText(tr("Open"));
  picture->setIconText(tr("Save picture"));
  bar->addAction(open);
  bar->addAction(picture);
  bar->addSeparator();
  bar->addAction(mUndo);
  bar->addAction(mRedo);
  bar->addSeparator();
  buildViewActions(menuBar()->addMenu(tr("&View")), bar);

  QMenu* cut = menuBar()->addMenu(tr("&Cut"));
  QAction* addCut = add(cut, tr("&Add plane"), QKeySequence("C"), tr("Cut away the half that faces you"),
                        [this] { mCuts->addPlane(); });
  QAction* flip =
      add(cut, tr("&Flip"), QKeySequence("X"), tr("Take away the other side"), [this] { mCuts->flipSelected(); });
  QAction* remove =
      add(cut, tr("&Remove"), QKeySequence::Delete, tr("Remove the selected cut"), [this] { mCuts->removeSelected(); });
  addCut->setIconText(tr("Add cut"));
  bar->addSeparator();
  bar->addAction(addCut);

  QMenu* help = menuBar()->addMenu(tr("&Help"));
  connect(help->addAction(tr("&About Velum")), &QAction::triggered, this, &MainWindow::showAbout);
  mNeedScene += {beside, saveScene, saveAs, picture, addCut, flip, remove};
}

void MainWindow::buildViewActions(QMenu* menu, QToolBar* bar) {
  using scene::StandardView;
  struct Row {
    const char *name, *letter, *keys, *alternative;
    StandardView view;
    bool inBar;
  };
  static constexpr Row kRows[] = {{"&Anterior", "A", "1", "", StandardView::Anterior, true},
                                  {"&Posterior", "P", "Shift+1", "Ctrl+1", StandardView::Posterior, true},
                                  {"&Left", "L", "3", "", StandardView::Left, true},
                                  {"&Right", "R", "Shift+3", "Ctrl+3", StandardView::Right, true},
                                  {"&Superior", "S", "7", "", StandardView::Superior, true},
                                  {"&Inferior", "I", "Shift+7", "Ctrl+7", StandardView::Inferior, true},
                                  {"&Oblique", "", "0", "", StandardView::Oblique, false}};
  for (const Row& row : kRows) {
    QAction* action = menu->addAction(tr(row.name));
    action->setShortcuts(*row.alternative ? QList<QKeySequence>{QKeySequence(row.keys), QKeySequence(row.alternative)}
                                          : QList<QKeySequence>{QKeySequence(row.keys)});
    setTip(action, tr("Look from: %1").arg(tr(row.name).remove('&').toLower()));
    connect(action, &QAction::triggered, this, [this, view = row.view] { mViewport->lookFrom(view); });
    mNeedScene << action;
    if (!row.inBar) continue;
    action->setIconText(row.letter);
    bar->addAction(action);
  }
  menu->addSeparator();
  mProjection = menu->addAction(tr("&Parallel projection"));
  mProjection->setIconText(tr("Parallel"));
  mProjection->setCheckable(true);
  mProjection->setShortcut(QKeySequence("5"));
  setTip(mProjection, tr("Parallel (orthographic) instead of perspective"));
  connect(mProjection, &QAction::triggered, this, [this] { mViewport->toggleProjection(); });
  QAction* reset = menu->addAction(tr("&Reset view"));
  reset->setIconText(tr("Reset"));
  reset->setShortcut(QKeySequence("R"));
  setTip(reset, tr("See all of it from the front"));
  connect(reset, &QAction::triggered, this, [this] { mViewport->lookFrom(scene::defaultView(mDocument.scene())); });
  bar->addAction(mProjection);
  bar->addAction(reset);
  mNeedScene += {mProjection, reset};
}

void MainWindow::askOpen(bool add) {
  QStringList paths = QFileDialog::getOpenFileNames(
      this, tr("Open"), mPath.isEmpty() ? QString() : QFileInfo(mPath).path(), openFilter());
  openPaths(paths, add);
}

void MainWindow::askOpenFolder() {
  QString path = QFileDialog::getExistingDirectory(this, tr("Open a folder of DICOM slices"),
                                                   mPath.isEmpty() ? QString() : QFileInfo(mPath).path());
  if (!path.isEmpty()) openPaths({path});
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
  savePictureTo(path, dialog.options());
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
