// What becomes of the document: asking before work is lost, the journal, recent files, data that is missing, history.
#include <QCoreApplication>
#include <QFileDialog>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>

#include "MainWindow.h"
#include "RecentFiles.h"
#include "RecoveryBar.h"
#include "cut/CutPanel.h"
#include "velum/scene/json/Json.h"
#include "velum/session/document/Open.h"
#include "velum/session/look/Look.h"

namespace velum::gui {

namespace {

constexpr int kHistoryRows = 30;

QString toText(const std::string& text) { return QString::fromStdString(text); }

/// A label in a menu, where & is a mark.
QString menuText(const std::string& label) { return toText(label).replace('&', "&&"); }

}  // namespace

// Asking.

bool MainWindow::mayLeaveScene() {
  if (mUnattended || mPages->currentIndex() == 0 || !mDocument.isModified()) return true;
  QString name = mPath.isEmpty() ? tr("the scene") : QFileInfo(mPath).fileName();
  QMessageBox box(QMessageBox::Warning, tr("Unsaved changes"), tr("Save the changes of %1?").arg(name),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  box.setInformativeText(tr("What is not saved is lost."));
  box.button(QMessageBox::Save)->setText(tr("&Save"));
  box.button(QMessageBox::Discard)->setText(tr("&Don't save"));
  box.setDefaultButton(QMessageBox::Save);
  box.setEscapeButton(QMessageBox::Cancel);
  int answer = box.exec();
  if (answer == QMessageBox::Save) askSaveScene(false);
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && !mDocument.isModified());
}

void MainWindow::openAsked(const QStringList& paths, bool add) {
  if (paths.isEmpty()) return;
  bool isLook = paths.size() == 1 && session::isLookFile(paths.first().toStdString());  // leaves the scene open
  if (add || isLook || mayLeaveScene()) openPaths(paths, add);
}

void MainWindow::newScene() {
  rememberPicture();
  mPath.clear();
  mScenePath.clear();
  mMessages->hide();
  mPages->setCurrentIndex(0);
  replaceScene({}, {});
  mRecent->refresh();
}

void MainWindow::leave(int exitCode) {
  rememberPicture();
  discardWork();
  if (mJournal) mJournal->flush();
  QCoreApplication::exit(exitCode);
}

// Loading.

session::DataPolicy MainWindow::dataPolicy() const {
  return {session::recentFolders(session::recentList()), !mUnattended};
}

void MainWindow::finishLoad(std::shared_ptr<Loaded> loaded, bool add, const QString& path) {
  if (add || !locateMissing(*loaded)) return takeScene(*loaded, add, path);
  startJob(
      tr("Opening %1").arg(QFileInfo(path).fileName()),
      [loaded, policy = dataPolicy()](Progress& progress) {
        session::loadData(loaded->scene, {}, progress, policy, &loaded->notes);
        scene::placeSlices(loaded->scene);
      },
      [this, loaded, path] { takeScene(*loaded, false, path); });
}

/// Asks for each file that was not found. @return true when some were named, so that they are to be read
bool MainWindow::locateMissing(Loaded& loaded) {
  bool found = false;
  for (const auto& missing : session::missingData(loaded.scene)) {
    QFileInfo file(toText(missing.path));
    QMessageBox box(QMessageBox::Question, tr("Missing data"),
                    tr("The %1 of the scene is missing: %2").arg(toText(missing.what), file.fileName()),
                    QMessageBox::NoButton, this);
    box.setInformativeText(tr("It was %1, and is not near the scene, nor where you worked last.").arg(file.filePath()));
    auto* locate = box.addButton(tr("&Locate..."), QMessageBox::AcceptRole);
    auto* skip = box.addButton(tr("&Skip"), QMessageBox::RejectRole);
    box.setDefaultButton(locate);
    box.setEscapeButton(skip);
    box.exec();
    QString path;
    if (box.clickedButton() == locate)
      path = QFileDialog::getOpenFileName(this, tr("Where is %1?").arg(file.fileName()), file.path());
    if (path.isEmpty()) {
      loaded.notes.push_back(tr("opened without its %1 (%2)").arg(toText(missing.what), file.filePath()).toStdString());
      continue;
    }
    found = true;
    scene::setField(loaded.scene, missing.field, path.toStdString());
  }
  return found;
}

void MainWindow::replaceScene(scene::Scene scene, const QString& path) {
  discardWork();
  mIsReplacing = true;
  mDocument.replace(std::move(scene));
  mIsReplacing = false;
  mJournaledChange = mDocument.changeCount();
  describeWork();
  rememberFile(path);
}

// The journal.

void MainWindow::protectWork(const std::filesystem::path& root, bool offers) {
  mRecoveryRoot = root;
  mJournal = std::make_unique<session::Journal>(session::Journal::Options{root});
  mJournaledChange = mDocument.changeCount();
  mJournal->setErrorListener([this](const std::string& text) {
    QMetaObject::invokeMethod(
        this, [this, text] { mMessages->showError(toText(text)); }, Qt::QueuedConnection);
  });
  mRecent->refresh();
  if (offers) lookForWork();
}

void MainWindow::lookForWork() {
  auto found = std::make_shared<std::vector<session::LostWork>>();
  mScan = std::make_unique<Job>([found, root = mRecoveryRoot](Progress&) { *found = session::findLostWork(root); },
                                nullptr);
  connect(mScan.get(), &Job::finished, this, [this, found] {
    mScan.release()->deleteLater();
    mRecovery->offer(std::move(*found));
  });
  connect(mRecovery, &RecoveryBar::restoreWanted, this, [this] {
    if (mayLeaveScene()) restoreWork();
  });
  connect(mRecovery, &RecoveryBar::discardWanted, this, &MainWindow::askDiscardWork);
  mScan->start();
}

void MainWindow::journalChange() {
  if (!mJournal || mIsReplacing || mDocument.changeCount() == mJournaledChange) return;
  mJournaledChange = mDocument.changeCount();
  if (mPages->currentIndex() == 1) mJournal->record(mDocument.scene(), mDocument.undoLabel());
}

void MainWindow::describeWork() {
  if (mJournal) mJournal->describe(QFileInfo(mPath).fileName().toStdString(), mScenePath.toStdString());
}

void MainWindow::discardWork() {
  if (mJournal) mJournal->discard();
}

bool MainWindow::restoreWork() {
  const session::LostWork* work = mRecovery->current();
  if (!work) return false;
  QString path = toText(work->scenePath.empty() ? work->title : work->scenePath);
  auto read = [folder = work->folder, policy = dataPolicy()](Loaded& loaded, Progress& progress) {
    loaded.lost = std::make_unique<session::WorkClaim>(folder);
    loaded.scene = loaded.lost->readScene();
    session::loadData(loaded.scene, {}, progress, policy, &loaded.notes);
  };
  startLoad(tr("Restoring %1").arg(QFileInfo(path).fileName()), read, false, path);
  return true;
}

/// What was recovered is saved nowhere; only when it is safe in the new journal may the old one go.
void MainWindow::adoptLostWork(session::WorkClaim& lost) {
  mDocument.markModified();
  if (mJournal) mJournal->flush();
  lost.remove();
  mRecovery->next();
}

void MainWindow::askDiscardWork() {
  const session::LostWork* work = mRecovery->current();
  if (!work) return;
  QMessageBox box(QMessageBox::Warning, tr("Discard unsaved work"),
                  tr("Delete the unsaved work of %1 for good?").arg(toText(work->title)),
                  QMessageBox::Discard | QMessageBox::Cancel, this);
  box.button(QMessageBox::Discard)->setText(tr("&Delete"));
  box.setDefaultButton(QMessageBox::Cancel);
  if (box.exec() != QMessageBox::Discard) return;
  try {
    session::WorkClaim(work->folder).remove();
  } catch (const Error& error) {
    mMessages->showNote(QString::fromUtf8(error.what()));
  }
  mRecovery->next();
}

// Recent files.

void MainWindow::rememberFile(const QString& path) {
  QFileInfo file(path);
  mWantsPicture = !path.isEmpty() && file.exists();
  if (mWantsPicture) session::addRecent(session::recentList(), file.absoluteFilePath().toStdString());
}

void MainWindow::rememberPicture() {
  mWantsPicture = false;
  QFileInfo file(mPath);
  if (mPages->currentIndex() == 0 || mPath.isEmpty() || !file.exists()) return;
  saveRecentPicture(file.absoluteFilePath().toStdString(), mViewport->grabFramebuffer());
}

// Menus.

void MainWindow::buildDocumentActions(QMenu* file) {
  keepRecentMenu(file->addMenu(tr("Open &recent")), [this](const QString& path) { openAsked({path}); });
}

void MainWindow::buildHistory(QMenu* edit) {
  QMenu* history = edit->addMenu(tr("&History"));
  connect(history, &QMenu::aboutToShow, this, [this, history] {
    history->clear();
    auto add = [&](const std::vector<std::string>& labels, int i, void (session::Document::*step)()) {
      connect(history->addAction(menuText(labels[std::size_t(i)])), &QAction::triggered, this, [this, i, step] {
        for (int n = 0; n <= i; ++n) (mDocument.*step)();
      });
    };
    auto redo = mDocument.redoLabels(), undo = mDocument.undoLabels();
    for (int i = std::min(int(redo.size()), kHistoryRows) - 1; i >= 0; --i) add(redo, i, &session::Document::redo);
    if (!redo.empty()) history->addSection(tr("Now"));
    for (int i = 0; i < std::min(int(undo.size()), kHistoryRows); ++i) add(undo, i, &session::Document::undo);
    if (history->isEmpty()) history->addAction(tr("Nothing yet"))->setEnabled(false);
  });
}

}  // namespace velum::gui
