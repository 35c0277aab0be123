#include "gui/window/MainWindow.h"

#include <QApplication>
#include <QCloseEvent>
#include <QCoreApplication>
#include <QMimeData>

#include "core/BrickCache.h"
#include "core/Memory.h"
#include "gui/extrusion/ExtrusionRoom.h"
#include "gui/kit/CoreWords.h"
#include "gui/service/CallLater.h"
#include "gui/service/FieldUndo.h"
#include "gui/service/KeyboardFocus.h"
#include "gui/service/RecentFiles.h"
#include "gui/service/WheelScrolls.h"
#include "gui/window/FilmCommands.h"
#include "gui/window/HelpCommands.h"
#include "gui/window/HistoryCommands.h"
#include "gui/window/StatusLine.h"
#include "gui/window/TimeCommands.h"
#include "gui/window/ViewCommands.h"
#include "gui/window/VolumeCommands.h"

namespace velum::gui {

MainWindow::MainWindow()
    : mPlayer([this] { return mViews->isCurrent(); }),
      mFrame(*this, mSession.document(), mPlayer),
      mActions(this),
      mToolbox(mSession.document(), *this),
      mViews(new ViewGrid(mSession, mSelection, mToolbox, mFrame.pages)),
      mJobs(mSession, *mFrame.progress, *mFrame.messages, this),
      mParts{*this, mSession, mSelection, mToolbox,     *mViews,      *mFrame.messages, *mFrame.floating,
             mJobs, mPlayer,  mActions,   *mFrame.tabs, *mFrame.side, mFrame.menus} {
  session::giveWayToTheWindow();
  mSession.borrowContext();  // that of the 3D view
  setAcceptDrops(true);
  mFrame.setViews(mViews);
  buildRooms();
  connectRooms();
  new KeyboardFocus(*this, [this] { return mSession.file().isOpen() ? &mViews->keyboardView() : nullptr; });
  new WheelScrolls(*this);
  new FieldUndo(*this);
  mSession.setListener([this] { refresh(); });
  mSession.setWaker([this] { callLater(this, [this] { collect(); }); });
  refresh();
  if (!mActions.warning().isEmpty()) mFrame.messages->showNote(mActions.warning());
  resize(1440, 900);
}

MainWindow::~MainWindow() {
  mSession.setListener({});
  delete mLost;
  delete mFrame.side;  // a field that is being edited hands its text over as it goes: while there is a document
  mSession.dropJob();
  delete centralWidget();  // the views know the session
}

/// In the order in which their pages stand.
void MainWindow::buildRooms() {
  const WindowParts& parts = mParts;
  auto add = [this](auto* room) {
    mRooms.push_back(room);
    return room;
  };
  mLoads = new FileLoads(parts);
  mLost = new LostWork(parts, *mFrame.recovery, *mLoads);
  mExports = add(new ExportCommands(parts));
  mCarries = add(new CarryCommands(parts));
  mFiles = add(new FileCommands(parts, *mLoads, *mExports, *mCarries));
  auto* history = add(new HistoryCommands(parts));
  // Every number field shows its unit anew.
  connect(history, &HistoryCommands::preferencesChanged, this, [] {
    for (QWidget* widget : QApplication::topLevelWidgets())
      if (auto* window = qobject_cast<MainWindow*>(widget)) window->takePreferences();
  });
  auto* view = add(new ViewCommands(parts));
  mLook = add(new LookRoom(parts));
  auto* volumes = add(new VolumeCommands(parts, *mLoads));
  mPyramids = add(new PyramidCommands(parts, *mLoads));
  connect(mPyramids, &PyramidCommands::sourceWanted, volumes, &VolumeCommands::reread);
  connect(mPyramids, &PyramidCommands::openWanted, this, [this](const QString& path) { mFiles->openAsked({path}); });
  mStructures = add(new StructureRoom(parts));
  mModels = add(new ModelRoom(parts));
  mCuts = add(new CutRoom(parts));
  add(new ExtrusionRoom(parts));
  mMarks = add(new MarkRoom(parts, mModels->lettering()));
  connect(view, &ViewCommands::captionAsked, mMarks, &MarkRoom::addCaption);
  auto* time = add(new TimeCommands(parts, *mFrame.time));
  mTimeline = add(new TimelineRoom(parts, *mFrame.timeline));
  time->follow(*mTimeline);
  mFilms = add(new FilmCommands(parts));
  connect(mTimeline, &TimelineRoom::saveAsked, mFilms, &FilmCommands::askSaveFilm);
  add(new HelpCommands(parts));
  add(new StatusLine(parts, *statusBar()));
  mFrame.bar->fill(mActions);
}

/// Connects what one room asks for to the room that does it.
void MainWindow::connectRooms() {
  mModels->addLettering();
  connect(mFrame.empty, &EmptyState::openFiles, this, [this] { mFiles->askOpen(false); });
  connect(mFrame.empty, &EmptyState::openFolder, mFiles, &FileCommands::askOpenFolder);
  connect(mFrame.empty, &EmptyState::openSample, mLoads, &FileLoads::openSample);
  connect(mFrame.empty->recent(), &RecentRow::chosen, this, [this](const QString& path) { mFiles->openAsked({path}); });
  connect(mFiles, &FileCommands::newWindowAsked, this, &MainWindow::openSecondWindow);
  connect(mLoads, &FileLoads::lookOpened, this, [this](const QString& path) { look().importFrom(path); });
  connect(mLoads, &FileLoads::aboutToShow, this, [this] {
    mToolbox.stop();  // what it had begun was in the data before
    showViews(true);
    layout()->activate();
  });
  connect(mLost, &LostWork::restoreAsked, this, [this] {
    if (mFiles->mayLeave()) restoreWork();
  });
  connect(mStructures, &StructureRoom::openLabelsAsked, mFiles, &FileCommands::askOpenLabels);
  connect(mStructures, &StructureRoom::findAskedElsewhere, mModels, &ModelRoom::findType);
  connect(mExports, &ExportCommands::exportStructuresAsked, this,
          [this] { mExports->askExportStructures(mStructures->selectedIds()); });
  connect(&mStructures->commands(), &StructureCommands::exportAsked, mExports, &ExportCommands::askExportStructures);
  connect(&mCuts->membranes(), &MembraneRoom::exportSheetAsked, mExports, &ExportCommands::askExportSheet);
  connect(&mCuts->membranes(), &MembraneRoom::exportClippedAsked, mExports, &ExportCommands::askExportClipped);
  connect(&mJobs, &JobRunner::ended, this, &MainWindow::jobEnded);
  connect(&viewport(), &Viewport::failed, mFrame.messages, &MessageBar::showError);
  connect(&viewport(), &Viewport::drawnAnew, this,
          [this] { mFrame.messages->showNote(tr("The graphics driver was reset; the picture has been drawn anew.")); });
}

/// Takes over what jobs have computed.
void MainWindow::collect() {
  mSession.collect();
  viewport().playersTold();
}

void MainWindow::showViews(bool open) {
  mFrame.showViews(open);
  mActions.setSceneOpen(open);
}

void MainWindow::refresh() {
  const session::WorkFile& file = mSession.file();
  showViews(file.isOpen());
  mViews->refresh();
  for (Room* room : mRooms) room->refresh(mSession);
  mToolbox.refresh();
  setWindowTitle(file.path().empty() ? "Velum" : QString("%1[*] - Velum").arg(QString::fromStdString(file.name())));
  setWindowModified(file.isModified() && !file.path().empty());
}

void MainWindow::takePreferences() {
  if (const auto& volume = mSession.shown().volume.data; volume && volume->finer)
    volume->finer->bricks->setMostBytes(std::size_t(brickBudget()));
  refresh();
  for (QWidget* widget : findChildren<QWidget*>()) widget->update();
}

void MainWindow::showScene(scene::Scene scene, const QString& name) {
  session::Loaded loaded;
  loaded.scene = std::move(scene);
  mLoads->show(loaded, name);
}

void MainWindow::protectWork(const std::filesystem::path& root, bool offers) {
  mSession.file().protect(root, [this](const std::string& text) {
    callLater(this, [this, text] {
      text.empty() ? mFrame.messages->showNote(tr("The disk takes changes again: unsaved work is protected."))
                   : mFrame.messages->showError(inWords(text));
    });
  });
  mFrame.empty->recent()->refresh();
  if (offers) mLost->lookFor(root);
}

void MainWindow::openSecondWindow() {
  auto* window = new MainWindow;
  window->setAttribute(Qt::WA_DeleteOnClose);
  if (mSession.file().isProtected()) window->protectWork(mSession.file().recoveryRoot(), false);
  window->show();
}

// Events.

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile()) return event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  QStringList paths;
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile()) paths << url.toLocalFile();
  event->acceptProposedAction();
  mFiles->openAsked(paths, event->modifiers() & Qt::ControlModifier);
}

void MainWindow::leave(int exitCode) {
  mLoads->rememberPicture();
  mSession.file().discardJournal(true);
  QCoreApplication::exit(exitCode);
}

void MainWindow::abandon() {
  mSession.dropJob();
  session::WorkFile& file = mSession.file();
  file.isModified() ? file.flushJournal() : file.discardJournal(true);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!mFiles->mayLeave()) return event->ignore();
  mLoads->rememberPicture();
  mSession.file().discardJournal();
  mSession.dropJob();
  event->accept();
}

}  // namespace velum::gui
