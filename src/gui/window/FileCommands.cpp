#include "gui/window/FileCommands.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <exception>

#include "core/Memory.h"
#include "gui/kit/CoreWords.h"
#include "gui/service/RecentFiles.h"
#include "gui/service/SavePath.h"
#include "session/document/FileKinds.h"
#include "session/document/Open.h"
#include "session/look/Look.h"

namespace velum::gui {

namespace {

QString openFilter() {
  QString all, single;
  for (const auto& kind : session::readablePatterns()) {
    QString patterns = patternsOf(kind);
    all += (all.isEmpty() ? "" : " ") + patterns;
    single += QString(";;%1 (%2)").arg(QString::fromStdString(kind.name), patterns);
  }
  return FileCommands::tr("All that Velum reads (%1)").arg(all) + ";;" + FileCommands::tr("All files (*)") + single;
}

}  // namespace

FileCommands::FileCommands(const WindowParts& parts, FileLoads& loads, ExportCommands& exports, CarryCommands& carries)
    : Room(parts), mLoads(loads), mExports(exports), mCarries(carries) {
  QMenu* menu = parts.menu(MenuId::File);
  ActionTable& actions = parts.actions;
  addOpening(menu);
  menu->addSeparator();
  addSaving(menu);
  menu->addSeparator();
  actions.add(menu, "file.newWindow", tr("New &window"), tr("Open a second window with a scene of its own"),
              [this] { emit newWindowAsked(); });
  QAction* cancel = actions.add(menu, "file.cancel", tr("&Cancel what is running"), tr("Stop the load or the picture"),
                                [this] { mParts.jobs.cancel(); });
  cancel->setEnabled(false);
  connect(&parts.jobs, &JobRunner::busyChanged, cancel, &QAction::setEnabled);
  actions.add(menu, "file.quit", tr("&Quit"), tr("Leave Velum"), [this] { mParts.window.close(); });
}

void FileCommands::addOpening(QMenu* menu) {
  ActionTable& actions = mParts.actions;
  actions.add(menu, "file.new", tr("&New"), tr("Close what is open"), [this] {
    if (mayLeave()) newScene();
  });
  QAction* open = actions.add(menu, "file.open", tr("&Open..."), tr("Open a volume, labels, surfaces or a scene"),
                              [this] { askOpen(false); });
  actions.add(menu, "file.openFolder", tr("Open &folder..."),
              tr("Open a folder of DICOM images, or a store in Zarr or N5"), [this] { askOpenFolder(); });
  keepRecentMenu(menu->addMenu(tr("Open &recent")), [this](const QString& path) { openAsked({path}); });
  actions.addForScene(menu, "file.add", tr("&Add labels or surfaces..."), tr("Open beside what is open"),
                      [this] { askOpen(true); });
  mCarries.addAction(menu);
  addPhantoms(menu->addMenu(tr("Make a &phantom")));
  open->setIconText(tr("Open"));
}

void FileCommands::addPhantoms(QMenu* menu) {
  for (const auto& sample : session::sampleNames()) {
    QString name = QString::fromStdString(sample);
    mParts.actions.add(menu, "file.phantom." + name, name, tr("Compute the phantom %1 and its labels").arg(name),
                       [this, name] {
                         if (mayLeave()) mLoads.openPhantom(name, 0);
                       });
  }
}

void FileCommands::addSaving(QMenu* menu) {
  mParts.actions.addForScene(menu, "file.saveScene", tr("&Save scene"), tr("Save the scene"),
                             [this] { askSaveScene(false); });
  mParts.actions.addForScene(menu, "file.saveSceneAs", tr("Sa&ve scene as..."), tr("Save the scene under another name"),
                             [this] { askSaveScene(true); });
  mExports.addActions(menu);
}

// Asking.

bool FileCommands::mayLeave() {
  const session::WorkFile& file = mParts.session.file();
  if (mLoads.isUnattended() || !file.isModified()) return true;
  QString name = file.path().empty() ? tr("the scene") : QString::fromStdString(file.name());
  QMessageBox box(QMessageBox::Warning, tr("Unsaved changes"), tr("Save the changes of %1?").arg(name),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &mParts.window);
  box.setInformativeText(tr("What is not saved is lost."));
  box.button(QMessageBox::Save)->setText(tr("&Save"));
  box.button(QMessageBox::Discard)->setText(tr("&Don't save"));
  box.setDefaultButton(QMessageBox::Save);
  box.setEscapeButton(QMessageBox::Cancel);
  int answer = box.exec();
  if (answer == QMessageBox::Save) askSaveScene(false);
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && !file.isModified());
}

void FileCommands::openAsked(const QStringList& paths, bool add) {
  if (paths.isEmpty()) return;
  bool isLook = paths.size() == 1 && session::isLookFile(paths.first().toStdString());  // leaves the scene open
  if (add || isLook || mayLeave()) mLoads.openPaths(paths, add);
}

/// The folder of the open file; empty when nothing that is open has one.
QString FileCommands::folder() const {
  std::string path = mParts.session.file().path();
  return path.empty() ? QString() : QFileInfo(QString::fromStdString(path)).path();
}

void FileCommands::askOpen(bool add) {
  openAsked(QFileDialog::getOpenFileNames(&mParts.window, tr("Open"), folder(), openFilter()), add);
}

void FileCommands::askOpenFolder() {
  QString path = QFileDialog::getExistingDirectory(&mParts.window, tr("Open a folder of DICOM images"), folder());
  if (!path.isEmpty()) openAsked({path});
}

void FileCommands::askOpenLabels() {
  QString path = QFileDialog::getOpenFileName(&mParts.window, tr("Open labels beside what is open"), folder(),
                                              volumeFilters(tr("Labels")));
  if (!path.isEmpty()) mLoads.openLabels(path);
}

void FileCommands::askSaveScene(bool asNew) {
  const session::WorkFile& file = mParts.session.file();
  QString path = QString::fromStdString(file.scenePath());
  if (asNew || path.isEmpty()) {
    QFileInfo open(QString::fromStdString(file.path()));
    path = askSavePath(&mParts.window, tr("Save scene"), open.path() + "/" + open.baseName() + ".json",
                       saveFilters(io::FileKind::Scene));
    if (path.isEmpty()) return;
  }
  saveSceneTo(path);
}

void FileCommands::saveSceneTo(const QString& path) {
  try {
    mParts.session.file().save(path.toStdString());
    mParts.jobs.setError({});
    mLoads.rememberFile(QString::fromStdString(mParts.session.file().path()));
    mLoads.rememberPicture();
  } catch (const std::exception& error) {
    mParts.jobs.setError(QString::fromUtf8(error.what()));
  }
}

void FileCommands::newScene() {
  mLoads.rememberPicture();
  mParts.messages.hide();
  mParts.toolbox.stop();
  mParts.session.file().close();
  releaseFreeMemory();
}

}  // namespace velum::gui
